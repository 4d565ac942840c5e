"""Words for faults in ``[optimize]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "variables.of": ("a variable is a number of the spec", 'add of = "mechanism.links[id=1].points.A[0]"'),
    "variables": ("something has to be changed for a better design", "add [[optimize.variables]]"),
}
LISTS = {
    "variables.of": ("keys of the spec", 'of = ["mechanism.links[id=1].points.A[0]"]'),
    "variables.among": ("the values that there are", 'among = ["2 mm", "2.5 mm", "3 mm"]'),
    "least": ("results", 'least = ["kinematics.max(aS_D)"]'),
    "greatest": ("results", 'greatest = ["motion.eta"]'),
    "variables": ("what may be changed", "[[optimize.variables]]"),
}
