"""The pinion-type cutter of a ring: the land on its tip, and where it would cut away the tips of the ring's teeth.

S, the centre of the tip rounding, runs at the radius q = r_a0 - rho; the normal of the cutter's involute where the
rounding begins passes through S. The cutter meets the ring like a pinion with rounded corners.
"""

from __future__ import annotations

from math import acos, atan2, sqrt

import numpy as np

from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.interference import Corner, trimming_margin, trochoid_margin
from tmmcalc.gears.involute.internal.pair import InternalPair
from tmmcalc.gears.involute.internal.ring import Cutter, Ring, cutting
from tmmcalc.gears.involute.wheel import Wheel

POINTS = 17  # of a rounding that are looked at


def tip_lead(tool: Wheel, tip: float, rounding: float) -> float | None:
    """Angle [rad] of S from the axis of the cutter's tooth; negative: pointed, or narrower than its rounding.

    None: S lies within the base circle. ``tip`` and ``rounding`` are in modules.
    """
    orbit = tip - rounding
    if not orbit > tool.base:
        return None
    arm = sqrt(orbit**2 - tool.base**2)
    half = float(tool.half_angle) + float(involute(tool.transverse_angle))
    return half - (arm + rounding) / tool.base + atan2(arm, tool.base)


def largest_tip(tool: Wheel, rounding: float) -> float | None:
    """Radius of the tip circle at which a rounding leaves no land; None: the tooth has no room for it.

    >>> round(2 * largest_tip(Wheel(25), 0.0), 4)  # the pointed tooth
    28.1949
    """
    low = tool.base + rounding + 1e-12
    if (tip_lead(tool, low, rounding) or -1.0) < 0:
        return None

    def land(tip: np.ndarray, _: Indices) -> np.ndarray:
        return np.array([tip_lead(tool, float(each), rounding) for each in tip], float)

    high = low + 1.0
    while (tip_lead(tool, high, rounding) or 0.0) > 0:
        high += 1.0
    return float(bracketed(land, np.array([low]), np.array([high]))[0])


def cutter_margins(ring: Ring, cutter: Cutter, tip: float) -> tuple[float, float] | None:
    """Trochoid and feed-in margins [module] of a cutter against the ring's tip circle of radius ``tip``.

    Both are negative where the cutter would cut the tips of the ring away, while it generates or while it is fed in
    radially. None: the cutter has no tip, or the ring's tip lies within its base circle.
    """
    angle, distance, top = cutting(ring, cutter)
    tool = Wheel(cutter.teeth, cutter.shift, ring.helix, ring.rack)
    lead = tip_lead(tool, top, cutter.rounding)
    if lead is None or lead < 0 or tip < ring.base:
        return None
    pair = InternalPair(tool, ring, angle, distance, (top, tip))
    corners = _corners(tool, top, cutter.rounding, lead)
    return trochoid_margin(pair, corners), trimming_margin(pair, corners)


def _corners(tool: Wheel, tip: float, rounding: float, lead: float) -> list[Corner]:
    """Points of the rounding, from the tip circle to the involute."""
    half = float(tool.half_angle) + float(involute(tool.transverse_angle))
    if rounding == 0:
        return [(tip, half - lead)]
    orbit = tip - rounding
    last = acos(sqrt(orbit**2 - tool.base**2) / orbit)
    points = orbit + rounding * np.exp(1j * np.linspace(0.0, last, POINTS))
    return [(abs(each), half - lead - float(np.angle(each))) for each in points]
