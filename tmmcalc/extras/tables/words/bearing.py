"""Words for faults in ``[bearing]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "inner": ("a bearing has its inner ring", 'add inner = "150 mm"'),
    "outer": ("a bearing has its outer ring", 'add outer = "340 mm"'),
    "roller": ("rolling bodies have their diameter", 'add roller = "39 mm"'),
    "count": ("a bearing has rolling bodies", "add count = 14"),
}
