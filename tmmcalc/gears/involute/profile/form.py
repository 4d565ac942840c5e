"""The form radius: where the involute of a tooth begins.

LN >= 0: at L, where the fillet runs smoothly into it. LN < 0: where the trochoid of the undercut crosses it. The point
of the fillet with the normal slope alpha_t + delta lies, in axes from the base circle's point N outward and along the
line of action beyond N, at

    u = -d sin(delta),   b = |LN| + (d - d_b) - d (1 - cos(delta))

and on the involute when G = atan2(b, r_b + u) + LN/r_b + (phi - phi_L) - inv(alpha_R) vanishes. All differences are
taken in closed form, because G is of the order (LN/r_b)^3.
"""

from __future__ import annotations

from math import cos, pi, sin
from typing import NamedTuple

import numpy as np

from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.rounding import Rounding, Shape, rounding
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.linkage.plane import Real
from tmmcalc.numerics.roots import Indices, bracketed

SLIGHT = 1e-5  # |LN|/r_b below which G drowns in rounding; there rho_F = |LN|/2 but for higher orders


class Junction(NamedTuple):
    """Where fillet and involute meet; arrays of the shape of the wheel's shift."""

    slope: Number  # theta_F [rad] of the rounding's normal there
    curvature_radius: Number  # rho_F, of the involute, in normal modules


class _Undercut(NamedTuple):
    """Undercut wheels of one tool, arrays (m,)."""

    tip: Rounding
    base: float
    y: Real  # y_S
    excess: Real  # |LN|

    def local(self, delta: Real, which: Indices) -> tuple[Real, Real, Real]:
        """u, b and (phi - phi_L) of the point of the fillet with the slope alpha_t + delta."""
        tip, alpha, y = self.tip, self.tip.angle, self.y[which]
        theta = alpha + delta
        sine, product = np.sin(theta), np.sin(theta) * sin(alpha)
        across, first = tip.across(theta), tip.across(alpha)
        oval = (tip.width**2 - tip.height**2) * np.sin(delta) * np.sin(alpha + theta)
        reach = -y / sine + tip.height**2 / across
        rise = 2 * y * np.cos(alpha + delta / 2) * np.sin(delta / 2) / product
        rise = rise + tip.height**2 * oval / (across * first * (across + first))
        mixed = np.cos(theta) * first + cos(alpha) * across
        turned = -y * np.sin(delta) / product - tip.height**2 * oval / (across * first * mixed)
        along = self.excess[which] + rise - 2 * reach * np.sin(delta / 2) ** 2
        return -reach * np.sin(delta), along, turned / tip.reference

    def square(self, delta: Real, which: Indices) -> Real:
        """R^2 - r_b^2."""
        out, along, _ = self.local(delta, which)
        return out * (2 * self.base + out) + along**2

    def gap(self, delta: Real, which: Indices) -> Real:
        """G [rad], the angle from the involute to the fillet; positive: the fillet has cut the involute away."""
        out, along, turned = self.local(delta, which)
        square = np.maximum(out * (2 * self.base + out) + along**2, 0.0)
        own = np.arctan(np.sqrt(square) / self.base)
        return np.arctan2(along, self.base + out) - self.excess[which] / self.base + turned - involute(own)

    def crossing(self) -> tuple[Real, Real]:
        """delta and rho_F (m,)."""
        m = len(self.excess)
        start = np.zeros(m)
        ends = bracketed(self.square, start, np.full(m, pi / 2 - self.tip.angle))
        slight = self.excess < SLIGHT * self.base

        def equation(delta: Real, which: Indices) -> Real:
            halfway = self.square(delta, which) - self.excess[which] ** 2 / 4
            return np.where(slight[which], -halfway, self.gap(delta, which))

        delta = bracketed(equation, start, ends)
        rho = np.sqrt(np.maximum(self.square(delta, np.arange(m)), 0.0))
        return delta, np.where(slight, self.excess / 2, rho)


def junction(wheel: Wheel, shape: Shape = "ellipse") -> Junction:
    """Where the fillet of a wheel meets its involute, for a shift of any shape; raises as `rounding` does.

    >>> round(float(junction(Wheel(10, 0.0)).curvature_radius), 5)
    0.50576
    """
    tip = rounding(wheel, shape)
    limit, y = np.broadcast_arrays(np.asarray(tip.limit, float), np.asarray(tip.y, float))
    slope, rho = np.full(limit.shape, tip.angle), np.array(np.maximum(limit, 0.0))
    under = limit < 0
    if under.any():
        delta, crossing = _Undercut(tip, wheel.base, y[under], -limit[under]).crossing()
        slope[under] += delta
        rho[under] = crossing
    return Junction(slope, rho)


def form_radius(wheel: Wheel, shape: Shape = "ellipse") -> Number:
    """r_F: the lowest radius of the involute, in normal modules; an array if the shift is one.

    It does not depend on the mate. Raises as `rounding` does.

    >>> round(5 * float(form_radius(Wheel(10, 0.0))), 6)  # module 5 mm
    23.628029
    """
    return np.hypot(wheel.base, junction(wheel, shape).curvature_radius)
