"""A pinion in a ring without backlash; lengths positive, in normal modules; 1 is the pinion, 2 the ring.

    inv(alpha_tw) = inv(alpha_t) - 2 (x1 + x2) tan(alpha)/(z2 - z1)       a_w = (r2 - r1) cos(alpha_t)/cos(alpha_tw)

Both base circles touch the line of action on the same side of the pitch point:

    N2 ---- N1 ---- A2 ======== P ======== A1          rho2 = rho1 + N1N2,  N1N2 = a_w sin(alpha_tw)

The tip of the ring begins the contact at A2, the tip of the pinion ends it at A1 (the pinion drives).
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, sin
from typing import Literal

from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.ring import Ring, angle_of_distance, angle_of_shifts
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.wheel import Wheel

Tips = Literal["clearance", "plain", "clear"]


@record
class InternalPair:
    """A pinion and a ring in mesh."""

    pinion: Wheel
    ring: Ring
    angle: float  # alpha_tw [rad], operating transverse pressure angle
    distance: float  # a_w
    tips: tuple[float, float]  # r_a1, r_a2

    @property
    def reference_distance(self) -> float:
        """a, the distance of touching reference circles."""
        return self.ring.reference - self.pinion.reference

    @property
    def ratio(self) -> float:
        """u = z2/z1."""
        return self.ring.teeth / self.pinion.teeth

    @property
    def modification(self) -> float:
        """y = a_w - a; negative where x1 + x2 is positive."""
        return self.distance - self.reference_distance

    @property
    def operating(self) -> tuple[float, float]:
        """Radii r_w1, r_w2 of the operating pitch circles."""
        stretch = self.distance / self.reference_distance
        return self.pinion.reference * stretch, self.ring.reference * stretch

    @property
    def length(self) -> float:
        """N1N2 = a_w sin(alpha_tw)."""
        return self.distance * sin(self.angle)

    @property
    def starts(self) -> tuple[float, float]:
        """N1A2 and N2A1: radii of curvature of the pinion where the ring's tip meets it, of the ring where hers does.

        The first is negative where the ring's tip reaches beyond N1, and nan where it lies within the base circle.
        """
        first = float(self.pinion.curvature_at(self.tips[0]))
        return self.ring.curvature_at(self.tips[1]) - self.length, first + self.length

    @property
    def segment(self) -> tuple[float, float]:
        """rho1 at A2 and A1: the ends of the contact with the whole flanks."""
        return self.starts[0], float(self.pinion.curvature_at(self.tips[0]))

    @property
    def contact_ratio(self) -> float:
        """eps_alpha, transverse, with the whole flanks active."""
        start, end = self.segment
        return (end - start) / self.pinion.base_pitch

    @property
    def clearances(self) -> tuple[float, float]:
        """Radial clearances at the roots of the pinion and of the ring."""
        return (
            self.tips[1] - self.distance - float(self.pinion.root),
            self.ring.root - self.distance - self.tips[0],
        )


def internal_of_shifts(pinion: Wheel, ring: Ring, tips: Tips | tuple[float, float] = "clearance") -> InternalPair:
    """The pair of a pinion and a ring with their shifts; raises `NoSolutionError` as `angle_of_shifts` does.

    >>> pair = internal_of_shifts(Wheel(20), Ring(60))
    >>> pair.distance, round(pair.contact_ratio, 4)
    (20.0, 1.9497)
    """
    angle, distance = angle_of_shifts(pinion, ring)
    return _pair(pinion, ring, angle, distance, tips)


def internal_of_distance(
    pinion: Wheel, ring: Ring, distance: float, tips: Tips | tuple[float, float] = "clearance"
) -> InternalPair:
    """The pair of a centre distance: the shift of the pinion is kept, the ring takes the rest of x1 + x2.

    Raises `NoSolutionError` if the distance does not exceed the difference of the base radii.
    """
    total, angle = angle_of_distance(pinion, ring, distance)
    return _pair(pinion, replace(ring, shift=total - float(pinion.shift)), angle, distance, tips)


def _pair(pinion: Wheel, ring: Ring, angle: float, distance: float, tips: Tips | tuple[float, float]) -> InternalPair:
    """Tips by a rule, or radii.

    ``plain``: as the rack gives them, which leaves at least c* at the root of the pinion; ``clearance``: the same, and
    the teeth of the pinion cut short where they would leave less than c* at the root of a ring that its cutter made;
    ``clear``: the same, and the teeth of the ring cut short where they would reach into the fillet of the pinion or
    beyond N1.
    """
    if not isinstance(tips, str):
        return InternalPair(pinion, ring, angle, distance, tips)
    plain = float(pinion.plain_tip), ring.plain_tip
    kept = ring.root - distance - pinion.rack.clearance
    chosen = plain if tips == "plain" else (min(plain[0], kept), plain[1])
    if tips == "clear":
        form = float(junction(pinion).curvature_radius)
        chosen = chosen[0], max(chosen[1], hypot(ring.base, distance * sin(angle) + form))
    return InternalPair(pinion, ring, angle, distance, chosen)
