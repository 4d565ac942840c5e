"""Words for faults in ``[dyad]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "kind": ("a dyad has its kind, the letters of its joints", 'add kind = "RRR", or RRP, RPR, PRP, RPP'),
    "first": ("link a is moved by its outer joint", 'add [dyad.first] with point = ["100 mm", "200 mm"]'),
    "second": ("link b is moved by its outer joint", 'add [dyad.second] with point = ["900 mm", "400 mm"]'),
    "first.point": ("an outer joint has its place", 'add point = ["100 mm", "200 mm"]'),
    "second.point": ("an outer joint has its place", 'add point = ["900 mm", "400 mm"]'),
}

_VELOCITY = ("a velocity along x and y", 'velocity = ["0.3 m/s", "-0.4 m/s"]')
_ACCELERATION = ("an acceleration along x and y", 'acceleration = ["0.5 m/s^2", "0.1 m/s^2"]')
LISTS = {
    "first.velocity": _VELOCITY,
    "second.velocity": _VELOCITY,
    "first.acceleration": _ACCELERATION,
    "second.acceleration": _ACCELERATION,
}

INLINE = {
    "points_a": "points by name: E = [x, y]",
    "points_b": "points by name: E = [x, y]",
}
