"""Words for faults in ``[wheel]``: what a missing key is for, what to write in its tables."""

MISSING = {
    "teeth": ("a wheel has its number of teeth", "add teeth = 27"),
    "module": ("a wheel has its module", 'add module = "5 mm"'),
    "cutter.teeth": ("a cutter has its number of teeth", "add teeth = 20"),
}

INLINE = {"cutter": "cutter = { teeth = 20, shift = 0.1, rounding = 0.2 }"}
