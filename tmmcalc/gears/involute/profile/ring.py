"""The internal ring as the mate of external teeth: its spaces have the involutes of an external tooth of the same data.

Space axes: origin in the ring's centre, Y along the axis of the space. The bottom corner is rounded by an arc that
touches the involute and the root circle. With the arc's radius q its centre lies on the involute's parallel, and

    rho_F = q + sqrt((r_f - q)^2 - r_b^2)
"""

from __future__ import annotations

from math import atan2, hypot, pi, sqrt

import numpy as np

from tmmcalc.core.numerics.curves import Curve
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.outline import Element, checked
from tmmcalc.gears.involute.profile.rounding import ProfileError
from tmmcalc.gears.involute.wheel import Wheel


@record
class RingFlank:
    """One flank of an internal ring, on the side of negative X of a space; lengths in modules."""

    teeth: int
    base: float  # r_b
    base_half_angle: float  # half the angle [rad] of the space on the base circle
    tip: float  # r_a, the inner circle
    root: float  # r_f, the outer one
    form: float  # r_F, where the involute ends
    corner: float  # radius of the arc at the bottom
    centre: complex  # of the arc

    def on_involute(self, xi: Real | float) -> Plane:
        """Points of the involute at xi = rho/r_b."""
        xi = np.asarray(xi, float)
        return self.base * (1j - xi) * np.exp(1j * (self.base_half_angle - xi))

    def on_involute_rate(self, xi: Real | float) -> Plane:
        """Derivative of `on_involute`."""
        xi = np.asarray(xi, float)
        return 1j * self.base * xi * np.exp(1j * (self.base_half_angle - xi))

    def on_corner(self, angle: Real | float) -> Plane:
        """Points of the arc at the bottom, by the direction [rad] from its centre."""
        return self.centre + self.corner * np.exp(1j * np.asarray(angle, float))

    def on_corner_rate(self, angle: Real | float) -> Plane:
        """Derivative of `on_corner`."""
        return 1j * self.corner * np.exp(1j * np.asarray(angle, float))

    @property
    def element(self) -> Element:
        """The space, from its bottom inward; raises `NoSolutionError` if the teeth of the ring are pointed."""
        lowest, highest = (sqrt((radius / self.base) ** 2 - 1) for radius in (self.tip, self.form))
        bottom = float(np.angle(self.centre))
        end = bottom + float(np.angle((complex(self.on_involute(highest)) - self.centre) * np.exp(-1j * bottom)))
        return checked(
            Element(
                self.teeth,
                (
                    Curve(self.on_corner, self.on_corner_rate, bottom, end),
                    Curve(self.on_involute, self.on_involute_rate, highest, lowest),
                ),
                self.root,
                self.tip,
            )
        )


def ring_flank(like: Wheel, tip: float, root: float, corner: float | None = None) -> RingFlank:
    """The flank of a ring with the teeth, shift, helix and rack of the external wheel ``like`` [module].

    ``tip`` is the inner radius, ``root`` the outer one, ``corner`` the radius at the bottom of a space; None: that of
    the rack's tip, or the largest that fits. Raises `NoSolutionError` if the circles hold no involute between them.
    """
    base = like.base
    half = float(like.half_angle) + float(involute(like.transverse_angle))
    if not base <= tip < root:
        raise _none("the tip circle of a ring lies between base and root circle", tip, base, "a larger tip radius")
    largest = _largest_corner(base, half, root)
    radius = min(like.rack.radius, largest) if corner is None else corner
    if not 0 < radius <= largest * (1 + 1e-12):
        raise _none("the corner does not fit into the space", radius, largest, "a smaller corner radius")
    rho, centre = _corner(base, half, root, radius)
    if not hypot(base, rho) > tip:
        raise _none("the corner reaches beyond the tip circle", hypot(base, rho), tip, "a smaller corner radius")
    return RingFlank(like.teeth, base, half, tip, root, hypot(base, rho), radius, centre)


def _corner(base: float, half: float, root: float, radius: float) -> tuple[float, complex]:
    """rho_F and the centre of the corner."""
    arm = sqrt(max((root - radius) ** 2 - base**2, 0.0))
    rho = arm + radius
    angle = half - rho / base + atan2(arm, base)
    return rho, (root - radius) * complex(np.exp(1j * (pi / 2 + angle)))


def _largest_corner(base: float, half: float, root: float) -> float:
    """The radius of the arc that rounds the whole bottom; at most what reaches the base circle."""

    def beside(radius: Real, _: Indices) -> Real:
        arm = np.sqrt(np.maximum((root - radius) ** 2 - base**2, 0.0))
        return half - (arm + radius) / base + np.arctan2(arm, base)

    low, high = np.array([0.0]), np.array([root - base])
    if beside(low, np.array([0]))[0] <= 0:
        raise _none("the space is pointed below the root circle", root, base, "a smaller root radius")
    if beside(high, np.array([0]))[0] >= 0:
        return root - base
    return float(bracketed(beside, low, high)[0])


def _none(message: str, value: float, limit: float, remedy: str) -> ProfileError:
    return ProfileError(message, value, limit, where="ring profile", remedy=remedy)
