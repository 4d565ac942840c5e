"""Words for faults in ``[contact]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "load": ("a load presses the bodies together", 'add load = "1 kN"'),
    "table.x": ("a table has its places along x", 'add x = ["-1 mm", 0, "1 mm"]'),
    "table.y": ("a table has its places along y", 'add y = ["-1 mm", 0, "1 mm"]'),
    "table.h": ("a table has its gaps", "add h = [[0.001, 0], [0, 0.001]], a row for each y"),
}

LISTS = {
    "table.h": ("rows of gaps", 'h = [[0, "1 um"], ["1 um", "2 um"]]'),
    "table.h[]": ("a list of gaps", '[0, "1 um"]'),
}

INLINE = {
    "table": "table = { x = [...], y = [...], h = [[...], ...] }",
}
