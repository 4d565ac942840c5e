"""Words for faults in ``[reliability]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "rate": ("shocks come at a rate", "add rate = 0.36"),
}
