"""One wheel of the plane of the shifts: its sizes, and where its involute begins as a function of the shift."""

from __future__ import annotations

from functools import cached_property
from math import pi, sin

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.form import Form, Sloped, form_of
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

DEPTH = 5.0  # addenda below the reference circle down to which undercut is followed
THROUGH = 0.4  # reference radii below it, where no flank is left of a wheel of few teeth


@record
class Side:
    """One wheel of the frame, and its mate."""

    wheel: Wheel
    reference: float
    base: float
    mate_reference: float
    mate_base: float
    least: float  # x_min
    steepness: float  # dLN/dx
    thickness: float  # s_a,min
    flat: float  # psi at x = 0, + inv alpha_t [rad]
    fillet: Shape

    @cached_property
    def form(self) -> Form:
        """rho_F as a function of the shift; only made where undercut is followed."""
        addendum = self.wheel.rack.addendum
        # the main region lies above -h_a*; a wheel that can be free of undercut with x < 0 may have pieces far below
        # but not so far below that its tooth would be cut through
        deep = max(-DEPTH * addendum, -THROUGH * self.reference)
        return form_of(self.wheel, min(deep, -addendum) if self.least <= 0 else -addendum, self.fillet)

    def start(self, x: Values) -> Sloped:
        """rho_F, LN without undercut, and its derivative."""
        if np.any(x < self.least):
            return self.form(x)
        return (x - self.least) * self.steepness, np.full_like(x, self.steepness)


def side_of(own: Wheel, mate: Wheel, thickness: float, fillet: Shape) -> Side:
    """The side of a wheel against its mate; ``thickness`` is the least one of its tip."""
    steepness = 1 / sin(own.section.angle)
    flat = pi / (2 * own.teeth) + float(involute(own.section.angle))
    sizes = own.reference, own.base, mate.reference, mate.base
    return Side(own, *sizes, own.least_shift, steepness, thickness, flat, fillet)
