"""Words for faults in ``[[tolerances]]``: what to write in its lists."""

LISTS = {
    "of": ("keys of the spec", 'of = ["mechanism.links[id=1].points.A[0]"]'),
    "measured": ("deviations that were measured", 'measured = ["-0.01 mm", "0.02 mm"]'),
}
