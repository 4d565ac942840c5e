"""Words for faults in ``[rotor]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "mass": ("a rotor has its mass", 'add mass = "40 kg"'),
    "center": ("the centre of mass has its place along the axis", 'add center = "200 mm"'),
    "bearings": ("a rotor runs in two bearings", 'add bearings = [0, "400 mm"], their places along the axis'),
    "speed": ("bearing loads and tolerances depend on the speed", 'add speed = "3000 rpm"'),
    "planes": (
        "a rotor is balanced in two planes",
        'add planes = ["50 mm", "350 mm"], their places along the axis',
    ),
    "unbalances": ("a rotor has unbalances", "add [[rotor.unbalances]], one for each"),
    "unbalances.position": ("every unbalance has its place along the axis", 'add position = "120 mm"'),
}

LISTS = {
    "bearings": ("the places of the two bearings", 'bearings = [0, "400 mm"]'),
    "planes": ("the places of the two correction planes", 'planes = ["50 mm", "350 mm"]'),
}
