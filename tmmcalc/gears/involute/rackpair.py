"""A pinion on a rack without backlash; lengths in normal modules.

The rack is the basic rack itself (or one with other tips), its datum line r + x away from the axis, so it rolls on the
reference circle whatever the shift: the operating angle is alpha_t and the mate's radius of curvature is infinite.

    theta1 = 1 - N1P/rho1,  theta2 = 1 - rho1/N1P,  lambda = 1/rho1,  N1P = r sin(alpha_t)
"""

from __future__ import annotations

from math import pi, sin

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.contact import overlap_ratio
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values


@record
class RackPair:
    """A pinion and the rack that it drives."""

    pinion: Wheel
    addendum: float  # of the rack, from its datum line to its tip line
    tip: float  # r_a1, of the pinion
    form: float  # rho_F1: radius of curvature of the pinion where its involute begins

    @property
    def distance(self) -> float:
        """From the axis of the pinion to the datum line of the rack, r + x."""
        return self.pinion.reference + float(self.pinion.shift)

    @property
    def travel(self) -> float:
        """Travel of the rack in one turn of the pinion, in normal modules: 2 pi r."""
        return 2 * pi * self.pinion.reference

    @property
    def pitch_curvature(self) -> float:
        """N1P = r sin(alpha_t)."""
        return self.pinion.reference * sin(self.pinion.transverse_angle)

    @property
    def segment(self) -> tuple[float, float]:
        """rho1 where the rack's tip begins the contact and where the pinion's tip ends it."""
        angle = self.pinion.transverse_angle
        start = self.pitch_curvature - (self.addendum - float(self.pinion.shift)) / sin(angle)
        return start, float(self.pinion.curvature_at(self.tip))

    @property
    def margin(self) -> float:
        """N1A2 - rho_F1: negative where the rack's tip reaches into the pinion's fillet."""
        return self.segment[0] - self.form

    @property
    def contact_ratio(self) -> float:
        """eps_alpha with the whole flanks."""
        start, end = self.segment
        return (end - start) / self.pinion.base_pitch

    @property
    def shortened(self) -> float:
        """eps_alpha with the involute of the pinion that there is."""
        start, end = self.segment
        return (end - max(start, self.form)) / self.pinion.base_pitch

    @property
    def clearances(self) -> tuple[float, float]:
        """Radial clearances at the roots of the pinion and of the rack."""
        rack = self.pinion.rack
        deep = rack.addendum + rack.clearance
        return self.distance - self.addendum - float(self.pinion.root), self.distance + deep - self.tip

    def overlap(self, face_width: float) -> float:
        """eps_beta of a face width in normal modules."""
        return overlap_ratio(self.pinion.helix, face_width)


@record
class RackSliding:
    """n points of the line of action; lengths in normal modules."""

    rho1: Values  # (n,) radius of curvature of the pinion
    along: Values  # (n,) s, distance from the pitch point, negative before it
    theta1: Values  # (n,) specific sliding of the pinion
    theta2: Values  # (n,) specific sliding of the rack
    pressure: Values  # (n,) lambda, specific pressure
    active: NDArray[np.bool_]  # (n,) within the active segment


def rack_pair(
    pinion: Wheel, addendum: float | None = None, tip: float | None = None, fillet: Shape = "ellipse"
) -> RackPair:
    """A pinion on its rack; tips by the basic rack if they are not given.

    Raises `NoSolutionError` if the tip of the pinion lies within its base circle.

    >>> pair = rack_pair(Wheel(20))
    >>> round(pair.contact_ratio, 4), round(pair.margin, 12)
    (1.7688, 0.0)
    """
    chosen = float(pinion.plain_tip) if tip is None else tip
    if chosen <= pinion.base:
        raise NoSolutionError(
            f"the tip circle lies within the base circle (margin {chosen - pinion.base:.4g} modules)",
            where="rack and pinion",
            value=chosen,
            limit=pinion.base,
            remedy=f"a tip radius above {pinion.base:.4g} modules or a greater shift",
        )
    form = float(junction(pinion, fillet).curvature_radius)
    return RackPair(pinion, pinion.rack.addendum if addendum is None else addendum, chosen, form)


def rack_sliding(pair: RackPair, rho1: Values) -> RackSliding:
    """theta and lambda at radii of curvature of the pinion (n,), all positive.

    Raises `UsageError` at N1 and beyond.
    """
    rho1 = np.atleast_1d(np.asarray(rho1, dtype=float))
    if not np.all(rho1 > 0):
        raise UsageError(
            "sliding is not defined at the base point of the pinion and beyond",
            where="sliding",
            limit=0.0,
            remedy="points beyond N1",
        )
    pitch, (low, high) = pair.pitch_curvature, pair.segment
    inside = (rho1 >= low - 1e-12 * high) & (rho1 <= high * (1 + 1e-12))
    return RackSliding(rho1, rho1 - pitch, 1 - pitch / rho1, 1 - rho1 / pitch, 1 / rho1, inside)
