"""The form radius: where the involute of a tooth begins.

LN >= 0: at L, where the fillet runs smoothly into it. LN < 0: where the trochoid of the undercut crosses it. The
rounding of the rack touches the fillet along normals through the pitch point, inclined by u = alpha_t + delta to the
pitch line. The point of contact lies on the normal at the signed distance d from its foot, which is r cos(u) from the
centre. The angle from the involute of the same radius to the fillet is

    G = J(d/(r cos u)) - J(rho/r_b) + E(delta),   J(v) = v - arctan(v),   E' = -tan(u) d/(r cos u),   E(0) = 0
    rho^2 = d^2 - r^2 sin(delta) sin(u + alpha_t)

which is of the order (LN/r_b)^3 and keeps its digits down to the limit of undercut, where rho -> |LN|/2.
"""

from __future__ import annotations

from math import sin
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Real
from tmmcalc.gears.involute.profile.rounding import Rounding, Shape, rounding
from tmmcalc.gears.involute.wheel import Number, Wheel

SLIGHT = 1e-9  # |LN| below which the limit one half stands for rho_F/|LN|
_NEAR = 0.3  # [-] below it v - arctan(v) is summed as a series
_POINTS = 8  # of the Gauss rule for E


class Junction(NamedTuple):
    """Where fillet and involute meet; arrays of the shape of the wheel's shift."""

    slope: Number  # theta_F [rad] of the rounding's normal there
    curvature_radius: Number  # rho_F, of the involute, in normal modules


def junction(wheel: Wheel, shape: Shape = "ellipse") -> Junction:
    """Where the fillet of a wheel meets its involute, for a shift of any shape; raises as `rounding` does.

    >>> round(float(junction(Wheel(10, 0.0)).curvature_radius), 6)
    0.505761
    """
    tip = rounding(wheel, shape)
    limit, y = np.broadcast_arrays(np.asarray(tip.limit, float), np.asarray(tip.y, float))
    slope, rho = np.full(limit.shape, tip.angle), np.array(np.maximum(limit, -limit / 2))
    under = limit < -SLIGHT
    if under.any():
        lack = -limit[under]
        delta, ratio = _crossing(tip, wheel.base, -y[under], lack)
        slope[under] += delta
        rho[under] = lack * ratio
    return Junction(slope, rho)


def curvature_ratio(wheel: Wheel, lack: Real, shape: Shape = "ellipse") -> Real:
    """rho_F/|LN| of a wheel, whose shift is not read, at values |LN| >= 0 (m,): smooth down to one half at 0."""
    shift = wheel.least_shift - lack * sin(wheel.transverse_angle)
    tip = rounding(Wheel(wheel.teeth, shift, wheel.helix, wheel.rack), shape)
    return _crossing(tip, wheel.base, -np.asarray(tip.y, float), lack)[1]


def form_radius(wheel: Wheel, shape: Shape = "ellipse") -> Number:
    """r_F: the lowest radius of the involute, in normal modules; an array if the shift is one.

    It does not depend on the mate. Raises as `rounding` does.

    >>> round(5 * float(form_radius(Wheel(10, 0.0))), 6)  # module 5 mm
    23.628029
    """
    return np.hypot(wheel.base, junction(wheel, shape).curvature_radius)


def _crossing(tip: Rounding, base: float, centre: Real, lack: Real) -> tuple[Real, Real]:
    """delta and rho_F/|LN| (m,) of undercut wheels of one tool; ``centre`` is the depth of S below the pitch line."""
    r, angle, rho = tip.reference, tip.angle, tip.height
    # where the fillet of the inscribed circle reaches the foot of its normal, that of the ellipse has passed it
    passed = (rho + np.sqrt(rho * rho + 4 * r * np.maximum(centre, 0.0))) / (2 * r)
    last = np.arcsin(np.clip(passed, sin(angle), 1.0)) - angle
    gauss = rule(_POINTS)
    safe = np.maximum(lack, SLIGHT)

    def foot(u: Real, which: Indices) -> Real:
        return r * np.sin(u) - centre[which] / np.sin(u) - rho * rho / tip.across(u)

    def squared(delta: Real, which: Indices) -> Real:
        return foot(angle + delta, which) ** 2 - r * r * np.sin(delta) * np.sin(2 * angle + delta)

    # the crossing is at delta of the order |LN|^2, so its root is sought in the square root of delta
    def ahead(t: Real, which: Indices) -> Real:
        delta = t * t
        inner = angle + delta * gauss.points[:, None]
        swept = -delta * (gauss.weights @ (np.tan(inner) * foot(inner, which) / (r * np.cos(inner))))
        square = squared(delta, which)
        own = np.copysign(np.sqrt(np.abs(square)), square) / base
        u = angle + delta
        return (_lag(foot(u, which) / (r * np.cos(u))) - _lag(own) + swept) / safe[which] ** 3

    t = bracketed(ahead, np.zeros_like(lack), np.sqrt(last))
    crossing: Real = np.sqrt(np.maximum(squared(t * t, np.arange(lack.size)), 0.0)) / safe
    return t * t, np.where(lack > SLIGHT, crossing, 0.5)


def _lag(v: Real) -> Real:
    """J(v) = v - arctan(v)."""
    square = np.minimum(v * v, _NEAR**2)
    series = np.zeros_like(v)
    for k in range(14, 0, -1):
        series = (-1) ** (k + 1) / (2 * k + 1) + square * series
    result: Real = np.where(np.abs(v) < _NEAR, v**3 * series, v - np.arctan(v))
    return result
