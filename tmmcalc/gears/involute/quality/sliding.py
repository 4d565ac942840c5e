"""Specific sliding and specific pressure along the line of action (4.71, 4.72).

    N1 ---- A2 ======== P ======== A1 ---- N2        rho1 = N1K, rho2 = N2K of the point of contact K

theta is positive where a flank is faster than its mate (addendum) and vanishes at the pitch point P; lambda is the sum
of the curvatures, in modules. Both are unbounded at N1 and N2, which are never evaluated.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.pair import Pair
from tmmcalc.gears.model import Values


@record
class Sliding:
    """n points of the line of action; lengths in normal modules."""

    rho1: Values  # (n,) radius of curvature of wheel 1
    along: Values  # (n,) s, distance from the pitch point, negative before it
    theta1: Values  # (n,) specific sliding of wheel 1
    theta2: Values  # (n,) specific sliding of wheel 2
    pressure: Values  # (n,) lambda, specific pressure
    active: NDArray[np.bool_]  # (n,) within the active segment


@record
class SlidingExtremes:
    """Largest values of the active segment."""

    theta1: float  # at A2, where the contact begins; the most negative of wheel 1
    theta2: float  # at A1, where it ends; the most negative of wheel 2
    pressure_start: float  # lambda at A2
    pressure_pitch: float  # lambda at P
    pressure_end: float  # lambda at A1
    pressure_largest: float  # largest lambda of the segment


def slide(rho1: Values, rho2: Values, ratio: float) -> tuple[Values, Values]:
    """theta1, theta2 of flanks with these radii of curvature and u = z2/z1 > 0 (4.71).

    >>> theta1, theta2 = slide(np.array(10.151997), np.array(29.696548), 17 / 14)
    >>> round(float(theta1), 6), round(float(theta2), 6)
    (-1.408982, 0.584887)
    """
    return 1 - rho2 / (ratio * rho1), 1 - ratio * rho1 / rho2


def sliding(pair: Pair, rho1: Values, segment: tuple[float, float] | None = None) -> Sliding:
    """theta and lambda at radii of curvature of wheel 1, (n,) between 0 and N1N2, both ends left out.

    ``segment`` is the radius of curvature of wheel 1 at both ends of the active segment, by default A2 and A1.
    Raises `UsageError` for points at or beyond N1 and N2.
    """
    rho1 = np.atleast_1d(np.asarray(rho1, dtype=float))
    g = float(pair.length)
    rho2 = g - rho1
    if not (np.all(rho1 > 0) and np.all(rho2 > 0)):
        raise UsageError(
            "sliding is not defined at the ends of the line of action and beyond",
            where="sliding",
            limit=g,
            remedy="points between N1 and N2",
        )
    low, high = segment if segment is not None else whole_segment(pair)
    theta1, theta2 = slide(rho1, rho2, pair.ratio)
    pitch = float(pair.operating[0] * np.sin(pair.angle))
    inside = (rho1 >= low - 1e-12 * g) & (rho1 <= high + 1e-12 * g)
    return Sliding(rho1, rho1 - pitch, theta1, theta2, g / (rho1 * rho2), inside)


def whole_segment(pair: Pair) -> tuple[float, float]:
    """N1A2 and N1A1: radii of curvature of wheel 1 at the ends of the active segment."""
    return float(pair.starts[0]), float(pair.length - pair.starts[1])


def sliding_extremes(pair: Pair, segment: tuple[float, float] | None = None) -> SlidingExtremes:
    """The largest sliding and pressure; theta falls and rises all along the line, so it is extreme at the ends.

    lambda is least in the middle of N1N2 and grows towards both ends. Raises `UsageError` if the segment reaches N1
    or N2.
    """
    low, high = segment if segment is not None else whole_segment(pair)
    pitch = float(pair.operating[0] * np.sin(pair.angle))
    at = sliding(pair, np.array([low, pitch, high]), (low, high))
    return SlidingExtremes(
        float(at.theta1[0]),
        float(at.theta2[2]),
        float(at.pressure[0]),
        float(at.pressure[1]),
        float(at.pressure[2]),
        max(float(at.pressure[0]), float(at.pressure[2])),
    )
