"""Wheels of all sizes, shifts, helices and tools; not every one can be cut."""

from __future__ import annotations

from itertools import product
from math import radians

from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.rack import RACKS, Rack
from tmmcalc.gears.involute.wheel import Wheel

TOOLS = {
    14.5: RACKS["AGMA 14.5"],
    20: Rack(),
    20.1: RACKS["ISO 53 C"],
    25: Rack(radians(25), 1.0, 0.25, 0.2),
    30: Rack(radians(30), 0.8, 0.2),
}

SHIFTS = (-1.0, -0.4, 0.0, 0.5, 0.95, 1.4, 2.0)
EXTREMES: list[tuple[Wheel, Shape]] = [
    (Wheel(z, x, radians(helix), TOOLS[angle]), shape)
    for z, x, helix, angle in product((5, 8, 12, 17, 60, 1000), SHIFTS, (0, 20, 45), TOOLS)
    for shape in (("ellipse",) if helix == 0 else ("ellipse", "circle"))
]
