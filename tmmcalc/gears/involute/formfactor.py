"""Tooth form factor of a wheel with the load at its tip: the measure of equal bending strength.

The 30 degree tangents to the fillet give the weakest section (ISO 6336-3, method C); helical wheels by the equivalent
spur wheel in the normal section. A small Y_F means a strong tooth.
"""

from __future__ import annotations

from math import cos, pi, sin, sqrt, tan

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.gears.model import Values

STEPS = 7  # of Newton's method for the angle of the tangent; five are enough


@record
class ToothForm:
    """The weakest section of a tooth; lengths in normal modules, of the shape of the wheel's shift."""

    factor: Values  # Y_F
    chord: Values  # s_Fn
    arm: Values  # h_F of the bending force


def tooth_form(wheel: Wheel, tip: Number | None = None) -> ToothForm:
    """Y_F with the load at the tip radius [normal modules], by default r + h_a* + x without shortening.

    >>> round(float(tooth_form(Wheel(17)).factor), 4)
    2.9575
    """
    rack, x = wheel.rack, np.asarray(wheel.shift, dtype=float)
    alpha, depth, rho = rack.angle, rack.addendum + rack.clearance, rack.radius
    teeth = wheel.teeth / (cos(wheel.section.base_helix) ** 2 * cos(wheel.helix))
    highest = wheel.plain_tip if tip is None else tip
    radius = teeth / 2 + np.asarray(highest, dtype=float) - wheel.reference
    corner = pi / 4 - depth * tan(alpha) - (1 - sin(alpha)) * rho / cos(alpha)
    g = rho - depth + x
    turned = 2 / teeth * (pi / 2 - corner) - pi / 3
    v = np.full(x.shape, pi / 6)
    for _ in range(STEPS):
        v = v - (v - 2 * g / teeth * np.tan(v) + turned) / (1 - 2 * g / teeth / np.cos(v) ** 2)
    chord = teeth * np.sin(pi / 3 - v) + sqrt(3) * (g / np.cos(v) - rho)
    pressure = np.arccos(np.minimum(teeth * cos(alpha) / (2 * radius), 1.0))
    half = (pi / 2 + 2 * x * tan(alpha)) / teeth + float(involute(alpha)) - involute(pressure)
    load = pressure - half
    arm = 0.5 * (teeth * (cos(alpha) / np.cos(load) - np.cos(pi / 3 - v)) + rho - g / np.cos(v))
    return ToothForm(6 * arm * np.cos(load) / (chord**2 * cos(alpha)), chord, arm)
