"""Where the usable involute of a wheel begins, as a function of its shift that costs next to nothing.

It is LN at L, or rho_F where the fillet of an undercut tooth crosses the involute (see `profile.form`). rho_F/|LN| is a
smooth function of |LN|, so a polynomial stands for it where a contour asks for thousands of values.
"""

from __future__ import annotations

from functools import cache
from math import sin

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.form import curvature_ratio
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

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
    least, steepness = wheel.least_shift, 1 / sin(wheel.section.angle)
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
