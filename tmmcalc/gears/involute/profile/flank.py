"""The flank of an external tooth: fillet and involute in the axes of the tooth, for any shift.

Tooth axes: origin in the wheel's centre, Y along the axis of the tooth, the flank on the side of negative X. A point of
the involute is given by xi = rho/r_b = phi + tan(alpha_t), one of the fillet by the slope theta (see `rounding`).
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, pi, sin, sqrt, tan
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.curves import Curve
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.profile.form import form_radius, junction
from tmmcalc.gears.involute.profile.rounding import ProfileError, Rounding, Shape, rounding
from tmmcalc.gears.involute.wheel import Wheel

WAIST = np.linspace(0.0, 1.0, 129)  # of the fillet, where the thickness of the tooth is looked at


class Rolls(NamedTuple):
    """Roll angles [rad] of the notable points of a flank; 0 is the reference circle."""

    limit: float  # phi_L, b of the rack (4.82); below -tan(alpha_t): undercut
    form: float  # phi_F, where the involute begins; phi_L unless undercut
    root: float  # phi_D, c of the rack (4.93)
    tip: float  # phi_A (4.84)


@record
class Flank:
    """One flank of an external wheel, from the root circle to the tip; lengths in normal modules."""

    wheel: Wheel
    rounding: Rounding
    slope: float  # theta_F [rad], of the rounding's normal where the fillet ends
    lowest: float  # xi_F [rad], where the involute begins
    highest: float  # xi_a [rad], where it ends
    pointed: bool  # whether it ends below the tip circle, on the axis of the tooth

    @property
    def form(self) -> float:
        """r_F."""
        return self.wheel.base * hypot(1, self.lowest)

    @property
    def tip(self) -> float:
        """Radius where the flank ends: the tip circle, or the point of a pointed tooth."""
        return self.wheel.base * hypot(1, self.highest)

    @property
    def rolls(self) -> Rolls:
        """Roll angles of the points L, F, D, A."""
        start = tan(self.rounding.angle)
        limit, root = float(self.rounding.roll(self.rounding.angle)), float(self.rounding.roll(pi / 2))
        return Rolls(limit, self.lowest - start, root, self.highest - start)

    @property
    def base_half_angle(self) -> float:
        """Half the angle [rad] of the tooth on the base circle."""
        return float(self.wheel.half_angle) + float(involute(self.rounding.angle))

    def on_involute(self, xi: Real | float) -> Plane:
        """Points of the involute."""
        xi = np.asarray(xi, float)
        return self.wheel.base * (1j - xi) * np.exp(1j * (self.base_half_angle - xi))

    def on_involute_rate(self, xi: Real | float) -> Plane:
        """Derivative of `on_involute` by xi."""
        xi = np.asarray(xi, float)
        return 1j * self.wheel.base * xi * np.exp(1j * (self.base_half_angle - xi))

    def on_fillet(self, theta: Real | float) -> Plane:
        """Points of the fillet."""
        return self.rounding.cut(theta) * np.exp(1j * float(self.wheel.half_angle))

    def on_fillet_rate(self, theta: Real | float) -> Plane:
        """Derivative of `on_fillet` by theta."""
        return self.rounding.cut_rate(theta) * np.exp(1j * float(self.wheel.half_angle))

    @property
    def curves(self) -> tuple[Curve, Curve]:
        """Involute and fillet, from the tip down to the root circle."""
        return (
            Curve(self.on_involute, self.on_involute_rate, self.highest, self.lowest),
            Curve(self.on_fillet, self.on_fillet_rate, self.slope, pi / 2),
        )

    def half_angle_at(self, radius: Real | float) -> Real:
        """Half the angle [rad] of the tooth at radii (n,) from the root circle to the tip, on fillet or involute."""
        radius = np.atleast_1d(np.asarray(radius, float))
        angle = np.asarray(self.wheel.half_angle_at(np.maximum(radius, self.wheel.base)), float)
        below = radius < self.form
        tip, wanted = self.rounding, radius[below]

        def excess(theta: Real, which: Indices) -> Real:
            reach = tip.reach(theta)
            height = tip.reference - reach * np.sin(theta)
            return np.hypot(reach * np.cos(theta), height) - wanted[which]

        ends = np.full(wanted.size, self.slope), np.full(wanted.size, pi / 2)
        angle[below] = np.angle(self.on_fillet(bracketed(excess, *ends))) - pi / 2
        return angle


def flank_of(wheel: Wheel, tip: float | None = None, shape: Shape = "ellipse") -> Flank:
    """The flank of an external wheel up to the tip radius ``tip`` [module]; None: r + h_a* + x.

    The shift is one number. A tooth that is pointed below the tip circle ends at its point. Raises `NoSolutionError`
    where no tooth is left: root circle at the centre, no involute between form and tip circle, tooth cut off.

    >>> rolls = flank_of(Wheel(13, 0.25)).rolls
    >>> round(rolls.limit, 8), round(rolls.form, 8)
    (-0.35901319, -0.35901319)
    """
    if wheel.root <= 0:
        raise _none("the root circle shrinks to the centre", float(wheel.root), 0.0, "a larger shift, or more teeth")
    tool, found = rounding(wheel, shape), junction(wheel, shape)
    lowest = float(found.curvature_radius) / wheel.base
    radius = float(wheel.plain_tip) if tip is None else float(tip)
    form, point = wheel.base * hypot(1, lowest), float(_pointing(wheel))
    # LN = (x - x_min)/sin(alpha_t)
    least = float(wheel.shift) - float(tool.limit) * sin(tool.angle)
    spared = f"a shift of {least:.4f}, which leaves no undercut"
    if not radius > form:
        remedy = "a larger tip radius" if tool.limit >= 0 else spared
        raise _none("the tip circle lies below the beginning of the involute", radius, form, remedy)
    if not point > form:
        remedy = f"a shift of at most {_largest_shift(wheel, shape, least):.4f}" if tool.limit >= 0 else spared
        raise _none("the tooth is pointed below the beginning of the involute", point, form, remedy)
    highest = sqrt((min(radius, point) / wheel.base) ** 2 - 1)
    flank = Flank(wheel, tool, float(found.slope), lowest, highest, radius > point)
    waist = flank.slope + WAIST * (pi / 2 - flank.slope)
    least_angle = float(np.min(np.angle(flank.on_fillet(waist)))) - pi / 2
    if least_angle <= 0:
        raise _none("the undercut cuts the tooth off at its foot", 2 * least_angle * float(wheel.root), 0.0, spared)
    return flank


def _pointing(wheel: Wheel) -> Real:
    """Radius where the two flanks meet; that of the base circle if they meet below it."""
    half = np.asarray(wheel.half_angle + involute(wheel.transverse_angle))
    return wheel.base / np.cos(inverse_involute(np.maximum(half, 0.0)))


def _largest_shift(wheel: Wheel, shape: Shape, least: float) -> float:
    """The shift above ``least``, without undercut, at which the point of the tooth meets the form radius."""

    def spare(shift: Real, _: Indices) -> Real:
        other = replace(wheel, shift=shift)
        return _pointing(other) - form_radius(other, shape)

    return float(bracketed(spare, np.array([least]), np.array([float(wheel.shift)]))[0])


def _none(message: str, value: float, limit: float, remedy: str) -> ProfileError:
    return ProfileError(message, value, limit, where="tooth profile", remedy=remedy)
