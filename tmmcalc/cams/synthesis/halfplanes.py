"""The region of the axis of the cam under a rocker: an intersection of half planes, one pair for every cam angle.

Plane of the rocker, its length as the unit: the pivot A is 0, the roller in its lowest position C0 is 1, the rocker
turns counter-clockwise on its rise, u = e^(i dpsi). The axis is o = (l0/l2) e^(-i psi0). By (5.48) theta is within
its limit where

    side (w - Re(o conj u)) <= -t Im(o conj u),     w = 1 - delta psi',  t = tan[theta],  side = +1, -1

a half plane Re(o conj n) <= c with n = u e^(i[theta]) turned to the side, c = -side w cos[theta].
"""

from __future__ import annotations

from math import cos, pi

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pressure.angle import limited_phases
from tmmcalc.cams.program import Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.records import record

APART = 1e-5  # [rad] lines that are nearer count as one


@record
class Lines:
    """Half planes Re(o conj n) <= c."""

    normal: Complex  # (m,)
    bound: Values  # (m,)
    phi: Values  # (m,) [rad]
    side: Indices  # (m,) sign of theta at its limit

    def joined(self, *others: Lines) -> Lines:
        """These and others."""
        every = (self, *others)
        names = ("normal", "bound", "phi", "side")
        return Lines(*(np.concatenate([getattr(one, name) for one in every]) for name in names))

    def chosen(self, which: Indices | NDArray[np.bool_]) -> Lines:
        """Some of them."""
        return Lines(self.normal[which], self.bound[which], self.phi[which], self.side[which])

    def apart(self, others: Lines) -> Lines:
        """Those whose direction is none of the others'."""
        return self.chosen(np.all(np.abs(self.normal[:, None] - others.normal) > APART, axis=1))

    def over(self, points: Complex) -> Values:
        """How far outside each line the points (...) are, (..., m)."""
        return (points[..., None] * np.conj(self.normal)).real - self.bound


@record
class Family:
    """All half planes of one phase and one side."""

    program: Program
    kind: str
    limit: float
    side: int
    assembly: int
    part: Panels
    motion: Values  # (2, K, N) dpsi, psi'

    def lines(self, motion: Values) -> tuple[Complex, Values]:
        """Normals and bounds (...) for dpsi, psi' (2, ...)."""
        y, y1 = motion
        lean = pi - self.limit if self.side > 0 else self.limit
        return np.exp(1j * (y + lean)), -self.side * (1 - self.assembly * y1) * cos(self.limit)

    def at(self, phi: Values) -> Lines:
        """The lines at phi (m,), on both sides of every angle where a piece of the law ends."""
        edges, count = self.program.edges, len(self.program.edges) - 1
        own = np.array([phase.kind == self.kind for phase in self.program.phases])[self.program.places[0]]
        first, last = int(np.argmax(own)), count - 1 - int(np.argmax(own[::-1]))
        after = np.clip(np.searchsorted(edges, phi, side="right") - 1, first, last)
        before = np.clip(np.searchsorted(edges, phi, side="left") - 1, first, last)
        both = before != after
        twice, piece = np.concatenate((phi, phi[both])), np.concatenate((before, after[both]))
        normal, bound = self.lines(self.program.at(twice, piece)[:2])
        return Lines(normal, bound, twice, np.full(len(twice), self.side, dtype=np.intp))

    def sample(self) -> Lines:
        """The lines at all points of the panels and at their edges."""
        return self.at(np.sort(np.concatenate((self.part.x.ravel(), self.part.edges))))

    def highest(self, values: Values) -> tuple[float, float]:
        """The largest of a function on the panels (K, N) and where it is."""
        return self.part.extremes(values)[1]


def families(task: CamTask) -> tuple[Family, ...]:
    """The half planes of rise and return, two families each."""
    return tuple(
        Family(task.program, kind, limit, side, task.asked.assembly, part, motion)
        for kind, limit, part, motion in limited_phases(task)
        for side in (1, -1)
    )


def sampled(every: tuple[Family, ...]) -> Lines:
    """Lines of all families at the points of their panels."""
    first, *others = (family.sample() for family in every)
    return first.joined(*others)


def outside(every: tuple[Family, ...], point: complex) -> tuple[float, list[float]]:
    """How far outside the region a point is at most, and for every family the angle where it is farthest outside."""
    found = []
    for family in every:
        normal, bound = family.lines(family.motion)
        found.append(family.highest((point * np.conj(normal)).real - bound))
    return max(value for value, _ in found), [phi for _, phi in found]


def lines_at(every: tuple[Family, ...], places: list[float]) -> Lines:
    """The line of every family at its own angle."""
    first, *others = (family.at(np.array([phi])) for family, phi in zip(every, places, strict=True))
    return first.joined(*others)
