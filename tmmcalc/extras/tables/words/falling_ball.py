"""Words for faults in ``[falling_ball]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "radius": ("a ball has its radius", 'add radius = "1 mm"'),
    "drag": ("the air resists the ball", "add drag = 1e-4"),
    "decay": ("the radius decreases", "add decay = 0.5, in 1/s"),
}
