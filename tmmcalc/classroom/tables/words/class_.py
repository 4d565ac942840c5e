"""Words for faults in ``[class]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "drawn.of": ("what is drawn is a number of the spec", 'add of = "mechanism.links[id=1].points.A[0]"'),
    "asked": ("something has to be asked", "add [[class.asked]]"),
    "asked.result": ("what is asked is a result", 'add result = "kinematics.stroke_D"'),
}
LISTS = {
    "drawn": ("what each variant has its own of", "[[class.drawn]]"),
    "drawn.of": ("keys of the spec", 'of = ["mechanism.links[id=1].points.A[0]"]'),
    "drawn.times": ("the key that is multiplied", 'times = "mechanism.links[id=1].points.A[0]"'),
    "drawn.among": ("the values that there are", 'among = ["2 mm", "2.5 mm", "3 mm"]'),
    "asked": ("what is asked", "[[class.asked]]"),
    "asked.also": ("further names", 'also = ["H", "stroke"]'),
    "asked.after": ("names of asked results", 'after = ["omega_2"]'),
}
