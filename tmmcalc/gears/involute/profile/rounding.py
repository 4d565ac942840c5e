"""The rounding of the rack's tip across a wheel, and how it touches the fillet that it cuts.

Rack axes: the origin K lies where the straight right-hand flank of the rack's tooth meets the line that rolls on the
reference circle, X1 runs along this line, Y1 away from the wheel's centre. The rounding is an ellipse about S:

    S = (x_S, y_S),  half axes A along X1 and B along Y1;   a circle has A = B

theta is the slope of its normal below X1, from alpha_t at b, where the straight flank ends, to pi/2 at c on the tip
flat. The normal at the point of contact passes through Q, where the line touches the reference circle; d is its length
down to the contact, phi the roll angle at that moment:

    d(theta) = -y_S/sin(theta) + B^2/D,   r phi = x_S + y_S cot(theta) + (A^2 - B^2) cos(theta)/D
    D = sqrt(A^2 cos^2(theta) + B^2 sin^2(theta))
"""

from __future__ import annotations

from math import cos, pi, sin, tan
from typing import Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.rack import require_tool
from tmmcalc.gears.involute.wheel import Number, Wheel

Shape = Literal["circle", "ellipse"]  # the textbook's stand-in, of equal height, or the true section of a helical rack

SHARP = 1e-12  # [module] radius that stands for a sharp corner


class ProfileError(NoSolutionError):
    """No such tooth: ``what`` in words without numbers; ``value`` and ``limit`` are lengths in normal modules."""

    def __init__(self, what: str, value: float, limit: float, *, where: str, remedy: str) -> None:
        self.what = what
        self.lengths = value, limit
        super().__init__(
            f"{what}: {value:.6g} against {limit:.6g} modules", where=where, value=value, limit=limit, remedy=remedy
        )


@record
class Rounding:
    """The rounding of the tip of the rack against one wheel; arrays if the wheel's shift is; in normal modules."""

    reference: float  # r, of the wheel
    angle: float  # alpha_t [rad]
    x: Number  # x_S
    y: Number  # y_S; positive: S lies beyond the rolling line
    width: float  # A
    height: float  # B
    flat: float  # e_S, half the tip flat
    limit: Number  # LN, signed: radius of curvature of the involute that ends at b; negative: undercut

    def across(self, theta: Real | float) -> Real:
        """D."""
        return np.hypot(self.width * np.cos(theta), self.height * np.sin(theta))

    def reach(self, theta: Real | float) -> Real:
        """d, from Q down to the point of contact."""
        return -self.y / np.sin(theta) + self.height**2 / self.across(theta)

    def roll(self, theta: Real | float) -> Real:
        """Roll angle phi [rad] at which the point is cut."""
        cosine, sine = np.cos(theta), np.sin(theta)
        excess = (self.width**2 - self.height**2) * cosine / self.across(theta)
        return (self.x + self.y * cosine / sine + excess) / self.reference

    def radius_of_curvature(self, theta: Real | float) -> Real:
        """Radius of curvature of the rounding itself."""
        return (self.width * self.height) ** 2 / self.across(theta) ** 3

    def on_rack(self, theta: Real | float) -> Plane:
        """Points of the rounding in the rack's axes."""
        across = self.across(theta)
        along = self.x + self.width**2 * np.cos(theta) / across
        return along + 1j * (self.y - self.height**2 * np.sin(theta) / across)

    def cut(self, theta: Real | float) -> Plane:
        """Points of the fillet in the wheel's axes, Y through the point of the flank on the reference circle (4.75)."""
        place = 1j * self.reference + self.reach(theta) * np.exp(-1j * np.asarray(theta))
        return place * np.exp(-1j * self.roll(theta))

    def cut_rate(self, theta: Real | float) -> Plane:
        """Derivative of `cut` by theta."""
        cosine, sine, across = np.cos(theta), np.sin(theta), self.across(theta)
        bulge = (self.width**2 - self.height**2) * self.height**2 * sine / across**3
        roll_rate = -(self.y / sine**2 + bulge) / self.reference
        reach_rate = self.y * cosine / sine**2 + bulge * cosine
        reach = self.reach(theta)
        inner = reach_rate - 1j * reach * (1 + roll_rate)
        return (self.reference * roll_rate + inner * np.exp(-1j * np.asarray(theta))) * np.exp(-1j * self.roll(theta))

    def curvature(self, theta: Real | float) -> Real:
        """Curvature of the fillet, positive where it is hollow: Euler and Savary with the centre of the rounding."""
        own = self.radius_of_curvature(theta)
        depth = self.reach(theta) - own  # from Q down to the centre of curvature of the rounding
        lever = self.reference * np.sin(theta)
        return (lever + depth) / (own * (lever + depth) + depth**2)


def rounding(wheel: Wheel, shape: Shape = "ellipse") -> Rounding:
    """The tip of the rack against a wheel (4.85); the two shapes differ for helical wheels only.

    Raises `NoSolutionError` if the rounding is wider than the tooth of the rack.

    >>> tip = rounding(Wheel(30, 0.15))
    >>> round(float(tip.x), 7), round(float(tip.y), 7)
    (-0.6664117, -0.7200492)
    """
    rack, section = wheel.rack, wheel.section
    angle, deepest = section.angle, rack.addendum + rack.clearance
    height = max(section.radius if shape == "circle" else rack.radius, SHARP)
    width = height if shape == "circle" else height / cos(wheel.helix)
    require_tool(rack)
    end = rack.straight  # a small radius lets the straight flank run on below the addendum
    slant = np.hypot(width * cos(angle), height * sin(angle))
    inset = width**2 * cos(angle) / slant
    flat = pi / 4 * section.module - end * tan(angle) - inset
    return Rounding(
        wheel.reference,
        angle,
        (wheel.shift - end) * tan(angle) - inset,
        wheel.shift - deepest + height,
        width,
        height,
        max(float(flat), 0.0),
        wheel.reference * sin(angle) - (end - wheel.shift) / sin(angle),
    )
