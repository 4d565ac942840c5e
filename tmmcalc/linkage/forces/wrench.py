"""Forces with their moment, and the joints at which reactions act."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.model import Joint


class Wrench(NamedTuple):
    """A force (n,) [N] and its moment (n,) [N*m] about a point that the context names."""

    force: Plane
    moment: Real

    def about(self, d: Plane) -> Wrench:
        """The same wrench about the point at the vector ``d`` from the old one."""
        return Wrench(self.force, self.moment - cross(d, self.force))

    def plus(self, other: Wrench) -> Wrench:
        """Sum of two wrenches about the same point."""
        return Wrench(self.force + other.force, self.moment + other.moment)

    def minus(self, other: Wrench) -> Wrench:
        """Difference of two wrenches about the same point."""
        return Wrench(self.force - other.force, self.moment - other.moment)

    def times(self, factor: Real | float) -> Wrench:
        """The wrench as many times."""
        return Wrench(self.force * factor, self.moment * factor)

    def reversed(self) -> Wrench:
        """The opposite wrench."""
        return Wrench(-self.force, -self.moment)


NOTHING = Wrench(np.zeros((), np.complex128), np.zeros(()))


class Pivot(NamedTuple):
    """A revolute joint in place: the pin (n,) [m]."""

    r: Plane


class Slideway(NamedTuple):
    """A prismatic joint in place: the slider's point (n,) [m] and the unit direction of the line (n,)."""

    r: Plane
    e: Plane


Seat = Pivot | Slideway


def seat_of(joint: Joint, configuration: Configuration) -> Seat:
    """Where a joint stands; reactions of a prismatic one are taken at the slider's point of its line."""
    motion = configuration.motions[joint.links[0]]
    r = motion.point(joint.points[0]).r
    return Pivot(r) if joint.kind == "revolute" else Slideway(r, motion.u * joint.directions[0])


def sliding(joint: Joint, configuration: Configuration) -> tuple[Real, Real]:
    """Relative motion in a joint per unit of input speed, and its derivative: rate and rate2, each (n,).

    Revolute: angular, of the higher-numbered link against the lower-numbered one [rad/rad]. Prismatic: of the
    higher-numbered link along the line [m/rad].
    """
    low, high = sorted(joint.links)
    if joint.kind == "revolute":
        a, b = configuration.motions[low], configuration.motions[high]
        return b.omega - a.omega, b.eps - a.eps
    slide = configuration.slides[joint.name]
    sign = 1.0 if joint.links[0] == high else -1.0
    return sign * slide.ds, sign * slide.dds
