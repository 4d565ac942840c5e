"""Words for faults in ``[unsteady]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "acceleration": ("the input has its largest acceleration", 'add acceleration = "0.05 m/s^2"'),
}
