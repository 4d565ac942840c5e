"""Words for faults in ``[[paths]]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "point": ("a path is that of a point of a moving link", 'add point = "P"'),
    "through": ("a wanted path has points", 'add through = [["20 mm", "20 mm"], ["20 mm", "45 mm"]]'),
}

LISTS = {
    "through": ("the points that are to be passed", 'through = [["20 mm", "20 mm"], ["20 mm", "45 mm"]]'),
    "through[]": ("the coordinates of a point", 'through = [["20 mm", "20 mm"], ["20 mm", "45 mm"]]'),
    "shift": ("the way by which all points are moved", 'shift = ["20 mm", "5 mm"]'),
    "at": ("the input coordinates at the points", 'at = ["0 deg", "20 deg"]'),
}

ELEMENTS = {"": ("name", 'path "{}"')}
