"""The motion of links in time, at one position or at all."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.plane import LinkMotion, Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.results import Kinematics

Place = complex | Plane  # at one position, or at all (n,)


@record
class LinkState:
    """Motion of a link in time: place, velocity, acceleration of its base point and its rotation; numbers or (n,)."""

    base: complex
    r: Place
    v: Place
    a: Place
    u: Place
    omega: float | Real
    eps: float | Real

    def arm(self, p: Place) -> Place:
        """The vector from the base point to the point p of the link."""
        return (p - self.base) * self.u

    def point(self, p: Place) -> tuple[Place, Place]:
        """Velocity and acceleration of the point p of the link."""
        d = self.arm(p)
        return self.v + 1j * self.omega * d, self.a + (1j * self.eps - self.omega**2) * d

    def own(self, place: Place) -> Place:
        """The point of the link that lies at this place, in the link's axes."""
        return self.base + (place - self.r) / self.u


def in_time(motion: LinkMotion, result: Kinematics, row: int | None = 0) -> LinkState:
    """The motion of a link at one of its positions (None: at all), at the speed and acceleration of the result."""
    if row is None:
        rates = (*result.in_time(motion.v, motion.a), motion.u, *result.in_time(motion.omega, motion.eps))
        return LinkState(motion.base, motion.r, *rates)
    r, u, v, a = (complex(_at(z, row)) for z in (motion.r, motion.u, *result.in_time(motion.v, motion.a)))
    omega, eps = (float(_at(z, row)) for z in result.in_time(motion.omega, motion.eps))
    return LinkState(motion.base, r, v, a, u, omega, eps)


def _at(z: Plane | Real, row: int) -> Any:
    """The value at the position of what may be the same at all."""
    values = np.ravel(z)
    return values[row if len(values) > 1 else 0]


def turning_links(mechanism: Mechanism) -> set[int]:
    """Links that can turn: all that prismatic joints alone do not tie to the frame."""
    still, grown = {FRAME}, True
    while grown:
        ties = [set(j.links) for j in mechanism.joints if j.kind == "prismatic" and set(j.links) & still]
        grown = bool(set().union(*ties) - still)
        still = still.union(*ties)
    return {link.id for link in mechanism.links} - still
