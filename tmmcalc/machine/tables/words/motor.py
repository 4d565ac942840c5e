"""Words for faults in ``[motor]``: what a missing key is for, what to write in its lists and tables."""

LISTS = {
    "table.speed": ("a list of two speeds or more", 'speed = ["0 rpm", "1400 rpm", "1500 rpm"]'),
    "table.moment": ("a list of two moments or more", 'moment = ["15 N*m", "7.5 N*m", 0]'),
}

INLINE = {
    "table": 'table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
}
