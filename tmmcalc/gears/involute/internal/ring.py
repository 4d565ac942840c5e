"""A ring: the wheel with teeth inside. Its fields and all lengths are positive, in normal modules.

The sign of the shift is that of ISO 21771: a positive shift moves the tool towards the tip of the teeth, so it makes
the teeth of the ring thicker and both its tip and its root circle smaller. (GOST 19274 counts the other way:
x_GOST = -x.) In the formulas of ISO the number of teeth and all radii of a ring are negative, and with them every
formula of an external wheel holds; `Ring.signed` is that wheel.

         tip circle r_a = r - h_a* - x  <  r  <  root circle r_f = r + h_a* + c* - x
"""

from __future__ import annotations

from math import hypot, sin

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.pair import sum_of_shifts
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.involute.wheel import Wheel


@record
class Cutter:
    """A pinion-type shaper that cuts a ring; lengths in normal modules."""

    teeth: int  # z_0
    shift: float = 0.0  # x_0, falls as it is ground
    rounding: float = 0.0  # radius of its tip rounding
    tip: float | None = None  # r_a0; None: r_0 + h_a* + c* + x_0


@record
class Ring:
    """An internal involute wheel."""

    teeth: int  # |z_2|
    shift: float = 0.0  # x_2, ISO sign
    helix: float = 0.0  # beta [rad]
    rack: Rack = Rack()
    cutter: Cutter | None = None  # None: the root circle and the involute reach as deep as the rack's

    @property
    def signed(self) -> Wheel:
        """The wheel of ISO 21771, with negative number of teeth and radii."""
        return Wheel(-self.teeth, self.shift, self.helix, self.rack)

    @property
    def reference(self) -> float:
        """Radius r of the reference circle."""
        return -self.signed.reference

    @property
    def base(self) -> float:
        """Radius r_b of the base circle."""
        return -self.signed.base

    @property
    def plain_tip(self) -> float:
        """Radius of the tip circle by the rack, r - h_a* - x."""
        return self.reference - self.rack.addendum - self.shift

    @property
    def root(self) -> float:
        """Radius r_f of the root circle: of the cutter's tip, or by the rack r + h_a* + c* - x."""
        if self.cutter is not None:
            _, distance, tip = cutting(self, self.cutter)
            return distance + tip
        return self.reference + self.rack.addendum + self.rack.clearance - self.shift

    @property
    def form(self) -> float:
        """Radius r_F where the involute ends at the root: by the cutter's rounding, or by the rack r + h_a* - x."""
        if self.cutter is None:
            return self.reference + self.rack.straight - self.shift
        angle, distance, tip = cutting(self, self.cutter)
        base = Wheel(self.cutter.teeth, 0.0, self.helix, self.rack).base
        # the normal of the cutter's involute where its rounding begins passes through the centre of the rounding
        centre = tip - self.cutter.rounding
        end = float(np.sqrt(max(centre**2 - base**2, 0.0))) + self.cutter.rounding
        return hypot(self.base, distance * sin(angle) + end)

    def half_angle_at(self, radius: float) -> float:
        """theta [rad]: half the angle of the tooth at a radius of at least r_b."""
        return -float(self.signed.half_angle_at(-radius))

    def thickness_at(self, radius: float) -> float:
        """Arc thickness of the tooth in the normal section."""
        return float(self.signed.thickness_at(-radius))

    def curvature_at(self, radius: float) -> float:
        """Radius of curvature of the transverse involute at a radius; nan below the base circle."""
        return float(self.signed.curvature_at(radius))


def cutting(ring: Ring, cutter: Cutter) -> tuple[float, float, float]:
    """Generating angle [rad], centre distance and tip radius of the cutter of a ring.

    Raises `NoSolutionError` for a cutter that does not fit into the ring, or whose shift is too great for it.
    """
    if cutter.teeth >= ring.teeth:
        raise NoSolutionError(
            f"a cutter of {cutter.teeth} teeth does not fit into a ring of {ring.teeth}",
            where="cutter of the ring",
            value=float(cutter.teeth),
            limit=float(ring.teeth - 1),
            remedy="a cutter with fewer teeth",
        )
    tool = Wheel(cutter.teeth, cutter.shift, ring.helix, ring.rack)
    try:
        angle, distance = angle_of_shifts(tool, ring)
    except NoSolutionError as error:
        raise NoSolutionError(
            f"a cutter of {cutter.teeth} teeth cannot make this ring: its shift x0 = {cutter.shift:.6g} and x2 add up "
            f"to {error.value:.6g}, and have to stay below {error.limit:.6g}",
            where="cutter of the ring",
            value=error.value,
            limit=error.limit,
            remedy="a smaller shift of the cutter, fewer teeth of it, or a smaller x2",
        ) from None
    return angle, distance, float(tool.plain_tip) + ring.rack.clearance if cutter.tip is None else cutter.tip


def largest_sum(pinion: Wheel, ring: Ring) -> float:
    """x1 + x2 at which the operating angle vanishes; the sum has to be smaller."""
    start, total = pinion.transverse_angle, ring.teeth - pinion.teeth
    return float(involute(start)) * total / (2 * float(np.tan(pinion.rack.angle)))


def angle_of_shifts(pinion: Wheel, ring: Ring) -> tuple[float, float]:
    """Operating angle [rad] and centre distance of a pinion in a ring with their shifts.

    Raises `NoSolutionError` if the ring has no more teeth than the pinion, or if x1 + x2 is too great.
    """
    check_teeth(pinion, ring)
    start, total = pinion.transverse_angle, ring.teeth - pinion.teeth
    shifts = float(pinion.shift) + ring.shift
    inv = float(involute(start))
    slope, limit = 2 * float(np.tan(pinion.rack.angle)) / total, largest_sum(pinion, ring)
    if inv - slope * shifts <= 0:
        raise NoSolutionError(
            f"the involute of the operating pressure angle is not positive: x1 + x2 = {shifts:.6g}, "
            f"it has to stay below {limit:.6g} (margin {limit - shifts:.4g})",
            where="internal pair",
            value=shifts,
            limit=limit,
            remedy=f"x1 + x2 below {limit:.6g}: a smaller x1, or a smaller x2 (wider spaces of the ring)",
        )
    angle = float(inverse_involute(inv - slope * shifts))
    return angle, (ring.reference - pinion.reference) * float(np.cos(start) / np.cos(angle))


def angle_of_distance(pinion: Wheel, ring: Ring, distance: float) -> tuple[float, float]:
    """x1 + x2 and the operating angle [rad] of a centre distance.

    Raises `NoSolutionError` if the distance does not exceed the difference of the base radii.
    """
    check_teeth(pinion, ring)
    least = ring.base - pinion.base
    if distance <= least:
        raise NoSolutionError(
            f"the centre distance of {distance:.6g} modules does not exceed the difference of the base radii, "
            f"{least:.6g} (margin {distance - least:.4g})",
            where="internal pair",
            value=distance,
            limit=least,
            remedy=f"a centre distance above {least:.6g} modules, near {ring.reference - pinion.reference:.6g}",
        )
    total, angle = sum_of_shifts(pinion, ring.signed, -distance)
    return float(total), float(angle)


def check_teeth(pinion: Wheel, ring: Ring) -> None:
    """Raise `NoSolutionError` if the pinion does not fit into the ring at all."""
    if ring.teeth <= pinion.teeth:
        raise NoSolutionError(
            f"a pinion of {pinion.teeth} teeth does not fit into a ring of {ring.teeth}",
            where="internal pair",
            value=float(ring.teeth),
            limit=float(pinion.teeth + 1),
            remedy="a ring with more teeth than its pinion",
        )
