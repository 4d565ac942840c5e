"""Words for faults in ``[[constraints]]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "name": ("the rule calls every constraint by its name", 'add name = "calm"'),
}
