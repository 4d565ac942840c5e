"""The flank of a ring that a pinion-type cutter shapes: involute, and the fillet that its rounded tip leaves.

Space axes as in `ring`. The operating circle r_w0 of the cutter rolls inside that of the ring, r_w2; Q is where they
touch, on the line of centres. S, the centre of the cutter's tip rounding, runs at the radius q about the cutter's
centre. theta is the slope of the normal through Q and S, from the generating angle alpha_w0, where the involute ends,
to pi/2 on the root circle; d = QS, and the fillet lies beyond S by the radius of the rounding:

    d(theta) = sqrt(q^2 - r_w0^2 cos^2(theta)) - r_w0 sin(theta)
"""

from __future__ import annotations

from math import hypot, pi, sqrt

import numpy as np

from tmmcalc.core.numerics.curves import Curve
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.cutter import tip_lead
from tmmcalc.gears.involute.internal.ring import Cutter, Ring, cutting
from tmmcalc.gears.involute.profile.outline import Element, checked
from tmmcalc.gears.involute.profile.rounding import SHARP, ProfileError
from tmmcalc.gears.involute.wheel import Wheel


@record
class ShapedRing:
    """One flank of a shaped ring, on the side of negative X of a space; lengths in normal modules."""

    teeth: int
    base: float  # r_b
    base_half_angle: float  # half the angle [rad] of the space on the base circle
    tip: float  # r_a, the inner circle
    root: float  # r_f, the outer one
    angle: float  # alpha_w0 [rad], generating angle
    cutter_teeth: int  # z_0
    operating: tuple[float, float]  # r_w0, r_w2
    orbit: float  # q
    rounding: float  # of the cutter's tip
    lead: float  # angle [rad] of S from the axis of the cutter's tooth

    @property
    def highest(self) -> float:
        """rho_F/r_b, where the involute ends."""
        start = (self.operating[1] - self.operating[0]) * np.sin(self.angle)
        return float(start + sqrt(self.orbit**2 - self._cutter_base**2) + self.rounding) / self.base

    @property
    def form(self) -> float:
        """r_F."""
        return self.base * hypot(1, self.highest)

    @property
    def _cutter_base(self) -> float:
        return float(self.operating[0] * np.cos(self.angle))

    def _arm(self, theta: Real | float) -> Real:
        arm: Real = np.sqrt(self.orbit**2 - (self.operating[0] * np.cos(theta)) ** 2)
        return arm

    def reach(self, theta: Real | float) -> Real:
        """d, from Q to S; negative where S stays within the operating circle of the cutter."""
        return self._arm(theta) - self.operating[0] * np.sin(theta)

    def turn(self, theta: Real | float) -> Real:
        """How far [rad] the ring has turned counter-clockwise since the cutter's tooth stood in its space."""
        cosine, sine, reach = np.cos(theta), np.sin(theta), self.reach(theta)
        from_axis = np.arctan2(reach * cosine, self.operating[0] + reach * sine)
        return (from_axis - self.lead) * self.cutter_teeth / self.teeth

    def turn_rate(self, theta: Real | float) -> Real:
        """Derivative of `turn` by theta: S turns about the centre of the cutter."""
        return -self.reach(theta) / self._arm(theta) * self.cutter_teeth / self.teeth

    def on_fillet(self, theta: Real | float) -> Plane:
        """Points of the fillet."""
        out = (self.reach(theta) + self.rounding) * np.exp(1j * (pi - np.asarray(theta, float)))
        return (1j * self.operating[1] + out) * np.exp(-1j * self.turn(theta))

    def on_fillet_rate(self, theta: Real | float) -> Plane:
        """Derivative of `on_fillet`."""
        theta = np.asarray(theta, float)
        normal, pitch = np.exp(1j * (pi - theta)), self.operating[0]
        length = self.reach(theta) + self.rounding
        change = pitch**2 * np.cos(theta) * np.sin(theta) / self._arm(theta) - pitch * np.cos(theta)
        place, turned = 1j * self.operating[1] + length * normal, np.exp(-1j * self.turn(theta))
        return ((change - 1j * length) * normal - 1j * self.turn_rate(theta) * place) * turned

    def fillet_radius(self, theta: Real | float) -> Real:
        """Radius of curvature of the fillet, which is hollow (Euler and Savary)."""
        reach = self.reach(theta)
        bend = (1 / self.operating[0] - 1 / self.operating[1]) * reach
        return self.rounding + bend * reach / (np.sin(theta) + bend)

    def on_involute(self, xi: Real | float) -> Plane:
        """Points of the involute at xi = rho/r_b."""
        xi = np.asarray(xi, float)
        return self.base * (1j - xi) * np.exp(1j * (self.base_half_angle - xi))

    def on_involute_rate(self, xi: Real | float) -> Plane:
        """Derivative of `on_involute`."""
        xi = np.asarray(xi, float)
        return 1j * self.base * xi * np.exp(1j * (self.base_half_angle - xi))

    @property
    def element(self) -> Element:
        """The space, from its bottom inward; raises `NoSolutionError` if the teeth of the ring are pointed."""
        lowest = sqrt((self.tip / self.base) ** 2 - 1)
        curves = (
            Curve(self.on_fillet, self.on_fillet_rate, pi / 2, self.angle),
            Curve(self.on_involute, self.on_involute_rate, self.highest, lowest),
        )
        return checked(Element(self.teeth, curves, self.root, self.tip))


def shaped_ring(ring: Ring, cutter: Cutter, tip: float) -> ShapedRing:
    """The flank that ``cutter`` makes in a ring down to the tip radius ``tip`` [module].

    Raises `NoSolutionError` if the cutter is pointed or its rounding too large, or if no involute is left.
    """
    tool = Wheel(cutter.teeth, cutter.shift, ring.helix, ring.rack)
    angle, distance, top = cutting(ring, cutter)
    rounding = max(cutter.rounding, SHARP)
    orbit = top - rounding
    lead = tip_lead(tool, top, rounding)
    if lead is None:
        raise _none("the rounding of the cutter reaches below its base circle", orbit, tool.base)
    if lead < -1e-12:
        raise _none("the tip of the cutter is narrower than its rounding", 2 * lead * top, 0.0)
    inv = float(involute(ring.signed.transverse_angle))
    like = Wheel(ring.teeth, -ring.shift, ring.helix, ring.rack)
    operating = tool.base / float(np.cos(angle))
    found = ShapedRing(
        ring.teeth,
        ring.base,
        float(like.half_angle) + inv,
        tip,
        distance + top,
        angle,
        cutter.teeth,
        (operating, operating + distance),
        orbit,
        rounding,
        max(lead, 0.0),
    )
    if not ring.base <= tip < found.form:
        remedy = "another tip radius of the ring, or a smaller rounding of the cutter"
        what = "no involute is left between tip and fillet of the ring"
        raise ProfileError(what, tip, found.form, where="ring profile", remedy=remedy)
    return found


def _none(message: str, value: float, limit: float) -> ProfileError:
    remedy = "a cutter with a smaller tip radius, shift or rounding"
    return ProfileError(message, value, limit, where="ring profile", remedy=remedy)
