"""One wheel of the plane of the shifts: its sizes, and where its usable involute begins as a function of the shift.

It is LN at L, or rho_F where the fillet of an undercut tooth crosses the involute (see `profile.form`). rho_F/|LN| is a
smooth function of |LN|, so a polynomial stands for it where a contour asks for thousands of values.
"""

from __future__ import annotations

from functools import cache, cached_property
from math import pi, sin

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.form import curvature_ratio
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

DEPTH = 5.0  # addenda below the reference circle down to which undercut is followed
THROUGH = 0.4  # reference radii below it, where no flank is left of a wheel of few teeth
DEGREE = 32  # of the polynomial that stands for rho_F/|LN|

Sloped = tuple[Values, Values]  # a function and its derivative


@record
class Form:
    """rho_F of one wheel as a function of its shift, to 1e-12 of the module; below x_min by a polynomial of |LN|."""

    steepness: float  # dLN/dx
    least: float  # x_min
    deepest: float  # largest |LN| that the polynomial covers
    series: Values  # (2, DEGREE + 1) Chebyshev coefficients of rho_F/|LN| on [0, deepest] and of its derivative

    def __call__(self, shift: Values) -> Sloped:
        """rho_F and its derivative by the shift."""
        limit = (shift - self.least) * self.steepness
        slope = np.full_like(limit, self.steepness)
        under = limit < 0
        if not under.any():
            return limit, slope
        lack = -limit[under]
        angle = np.arccos(np.clip(2 * lack / self.deepest - 1, -1.0, 1.0))
        ratio, change = self.series @ np.cos(np.arange(DEGREE + 1)[:, None] * angle)
        limit[under] = lack * ratio
        slope[under] = -self.steepness * (ratio + lack * change)
        return limit, slope


def form_of(wheel: Wheel, lowest: float, shape: Shape = "ellipse") -> Form:
    """The form function of a wheel for shifts from ``lowest`` up; raises as `rounding` does."""
    least, steepness = wheel.least_shift, 1 / sin(wheel.transverse_angle)
    if least <= lowest:
        return Form(steepness, least, 1.0, np.zeros((2, DEGREE + 1)))
    deepest = max(least - lowest, 0.01) * steepness
    cosines = _cosines()
    values = curvature_ratio(wheel, deepest * (1 + cosines[1]) / 2, shape)
    series = 2 / (DEGREE + 1) * cosines @ values
    series[0] /= 2
    slopes = np.append(np.polynomial.chebyshev.chebder(series), 0.0) * 2 / deepest
    return Form(steepness, least, deepest, np.vstack((series, slopes)))


@cache
def _cosines() -> Values:
    """Chebyshev polynomials (rows) at the nodes (columns)."""
    angle = np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
    return np.cos(np.arange(DEGREE + 1)[:, None] * angle)


@record
class Side:
    """One wheel of the frame, and its mate."""

    wheel: Wheel
    reference: float
    base: float
    mate_reference: float
    mate_base: float
    least: float  # x_min
    steepness: float  # dLN/dx
    thickness: float  # s_a,min
    flat: float  # psi at x = 0, + inv alpha_t [rad]
    fillet: Shape

    @cached_property
    def form(self) -> Form:
        """rho_F as a function of the shift; only made where undercut is followed."""
        addendum = self.wheel.rack.addendum
        # the main region lies above -h_a*; a wheel that can be free of undercut with x < 0 may have pieces far below
        # but not so far below that its tooth would be cut through
        deep = max(-DEPTH * addendum, -THROUGH * self.reference)
        return form_of(self.wheel, min(deep, -addendum) if self.least <= 0 else -addendum, self.fillet)

    def start(self, x: Values) -> Sloped:
        """rho_F, LN without undercut, and its derivative."""
        if np.any(x < self.least):
            return self.form(x)
        return (x - self.least) * self.steepness, np.full_like(x, self.steepness)


def side_of(own: Wheel, mate: Wheel, thickness: float, fillet: Shape) -> Side:
    """The side of a wheel against its mate; ``thickness`` is the least one of its tip."""
    steepness = 1 / sin(own.transverse_angle)
    flat = pi / (2 * own.teeth) + float(involute(own.transverse_angle))
    sizes = own.reference, own.base, mate.reference, mate.base
    return Side(own, *sizes, own.least_shift, steepness, thickness, flat, fillet)
