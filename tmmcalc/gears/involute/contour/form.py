"""Where the usable involute of a wheel begins: at L, or where the fillet of an undercut tooth crosses the involute.

The tip rounding of the rack touches the fillet along normals through the pitch point, inclined by u to the pitch line.
The point of contact lies on the normal at the signed distance d from its foot, which is r cos u from the centre. With
delta = u - alpha_t the angle from the involute of the same radius to the fillet is

    G = J(d/(r cos u)) - J(rho/r_b) + E(delta),   J(v) = v - arctan(v),   E' = -tan(u) d/(r cos u),   E(0) = 0
    rho^2 = d^2 - r^2 sin(delta) sin(u + alpha_t)

which keeps its digits down to the limit of undercut, where rho -> |LN|/2. So rho/|LN| is a smooth function of |LN|, and
a polynomial stands for it where a contour asks for thousands of values.
"""

from __future__ import annotations

from math import sin

import numpy as np

from tmmcalc.gears.involute.profile.rounding import Shape, rounding
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values
from tmmcalc.numerics.panels import rule
from tmmcalc.numerics.roots import Indices, bracketed
from tmmcalc.records import record

DEGREE = 32  # of the polynomial that stands for rho_F/|LN|
SLIGHT = 1e-9  # |LN| below which the limit one half stands for the ratio
_NEAR = 0.3  # [-] below it v - arctan(v) is summed as a series
_POINTS = 8  # of the Gauss rule for E

Sloped = tuple[Values, Values]  # a function and its derivative


def form_curvature(wheel: Wheel, shape: Shape = "ellipse") -> Values:
    """rho_F: radius of curvature at the lowest usable point of the involute, LN unless the tooth is undercut.

    Any shape of the wheel's shift; in normal modules. Raises as `rounding` does.

    >>> round(float(form_curvature(Wheel(10, 0.0))), 6)
    0.505761
    """
    limit = np.asarray(wheel.limit, dtype=float)
    if not np.any(limit < 0):
        return limit
    flat = limit.ravel()
    lack = -flat[flat < 0]
    result = flat.copy()
    result[flat < 0] = lack * _ratio(wheel, lack, shape)
    return result.reshape(limit.shape)


def _ratio(wheel: Wheel, lack: Values, shape: Shape) -> Values:
    """rho_F/|LN| of the given |LN|, (m,)."""
    r, base, angle = wheel.reference, wheel.base, wheel.section.angle
    shift = wheel.least_shift - lack * sin(angle)
    tip = rounding(Wheel(wheel.teeth, shift, wheel.helix, wheel.rack), shape)
    centre, rho = -np.asarray(tip.y), tip.height
    # where the fillet of the inscribed circle reaches the foot of its normal, that of the ellipse has passed it
    passed = (rho + np.sqrt(rho * rho + 4 * r * np.maximum(centre, 0.0))) / (2 * r)
    last = np.arcsin(np.clip(passed, sin(angle), 1.0)) - angle
    gauss = rule(_POINTS)
    safe = np.maximum(lack, SLIGHT)

    def foot(u: Values, which: Indices) -> Values:
        return r * np.sin(u) - centre[which] / np.sin(u) - rho * rho / tip.across(u)

    def squared(delta: Values, which: Indices) -> Values:
        return foot(angle + delta, which) ** 2 - r * r * np.sin(delta) * np.sin(2 * angle + delta)

    # the crossing is at delta of the order |LN|^2, so its root is sought in the square root of delta
    def ahead(t: Values, which: Indices) -> Values:
        delta = t * t
        inner = angle + delta * gauss.points[:, None]
        swept = -delta * (gauss.weights @ (np.tan(inner) * foot(inner, which) / (r * np.cos(inner))))
        square = squared(delta, which)
        own = np.copysign(np.sqrt(np.abs(square)), square) / base
        u = angle + delta
        return (_lag(foot(u, which) / (r * np.cos(u))) - _lag(own) + swept) / safe[which] ** 3

    t = bracketed(ahead, np.zeros_like(lack), np.sqrt(last))
    crossing: Values = np.sqrt(np.maximum(squared(t * t, np.arange(lack.size)), 0.0)) / safe
    return np.where(lack > SLIGHT, crossing, 0.5)


def _lag(v: Values) -> Values:
    """J(v) = v - arctan(v)."""
    square = np.minimum(v * v, _NEAR**2)
    series = np.zeros_like(v)
    for k in range(14, 0, -1):
        series = (-1) ** (k + 1) / (2 * k + 1) + square * series
    result: Values = np.where(np.abs(v) < _NEAR, v**3 * series, v - np.arctan(v))
    return result


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


def form_of(wheel: Wheel, lowest: float) -> Form:
    """The form function of a wheel for shifts from ``lowest`` up; raises as `rounding` does."""
    least, steepness = wheel.least_shift, 1 / sin(wheel.section.angle)
    if least <= lowest:
        return Form(steepness, least, 1.0, np.zeros((2, DEGREE + 1)))
    deepest = max(least - lowest, 0.01) * steepness
    angle = np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
    values = _ratio(wheel, deepest * (1 + np.cos(angle)) / 2, "ellipse")
    series = 2 / (DEGREE + 1) * np.cos(np.arange(DEGREE + 1)[:, None] * angle) @ values
    series[0] /= 2
    slopes = np.append(np.polynomial.chebyshev.chebder(series), 0.0) * 2 / deepest
    return Form(steepness, least, deepest, np.vstack((series, slopes)))
