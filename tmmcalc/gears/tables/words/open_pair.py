"""Words for faults in ``[open_pair]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "cutter.teeth": ("a cutter has its number of teeth", "add teeth = 20"),
}

INLINE = {
    "cutter": "cutter = { teeth = 20, shift = 0.1, rounding = 0.2 }",
}
