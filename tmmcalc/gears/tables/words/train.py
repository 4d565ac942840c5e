"""Words for faults in ``[train]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "layout": ("a train has its layout", 'add layout = "AI", or several: layout = ["AI", "AIbar"]'),
}

LISTS = {
    "modules": ("the modules of the two stages", 'modules = ["2 mm", "3.5 mm"]'),
}
