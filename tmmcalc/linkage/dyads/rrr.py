"""Dyad RRR: two links, three revolute joints.

              B
           a / \\ b          a: P1 -> B, length l_a;  b: P2 -> B, length l_b
            /   \\
          P1     P2

Variant +1: B lies to the left of the directed line P1 -> P2, so P1, B, P2 are passed clockwise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Point, Real, cross, rotated, square, vector
from tmmcalc.linkage.dyads.base import Elements, Motions, Rates, Sites, Slides, length_of, mm
from tmmcalc.linkage.solvers import Method
from tmmcalc.linkage.structure import Group


class RRRPlaced(NamedTuple):
    """Placement: the vectors a = P1 -> B and b = P2 -> B [m]."""

    a: Plane
    b: Plane


class RRRMount(NamedTuple):
    """RRR: both links turn about their outer pins."""

    pin_a: complex  # outer joint of a, in the axes of a
    pin_b: complex
    vector_a: complex  # outer to inner joint, in the axes of a
    vector_b: complex

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: RRRPlaced, rates: Rates) -> None:
        """Base points are the outer pins."""
        a, b = at.links
        motions[a] = rotated(self.pin_a, at.port1, placed.a / self.vector_a, rates.x, rates.xx)
        motions[b] = rotated(self.pin_b, at.port2, placed.b / self.vector_b, rates.y, rates.yy)


class RRR(NamedTuple):
    """RRR with lengths ``l_a``, ``l_b`` [m] and the variant +1 or -1 (textbook 2.5.3, (2.8) to (2.17))."""

    l_a: float
    l_b: float
    variant: int = 1

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[RRR, RRRMount]:
        """Its lengths are those of the vectors between the pins."""
        vector_a, vector_b = (
            elements.inner_a.point - elements.outer_a.point,
            elements.inner_b.point - elements.outer_b.point,
        )
        mount = RRRMount(elements.outer_a.point, elements.outer_b.point, vector_a, vector_b)
        a, b = (length_of(each, link, group) for each, link in zip((vector_a, vector_b), group.links, strict=True))
        return cls(a, b, variant), mount

    def margin(self, port1: Point, port2: Point) -> Real:
        """Squared sine of the angle at B; negative where q is outside [|l_a - l_b|, l_a + l_b]."""
        q2 = square(port2.r - port1.r)
        return self._spread(q2) / (4 * self.l_a**2 * self.l_b**2)

    def _spread(self, q2: Real) -> Real:
        """(2 a x b)^2 as a product of two factors, each exact near its own limit position."""
        return ((self.l_a + self.l_b) ** 2 - q2) * (q2 - (self.l_a - self.l_b) ** 2)

    def place(self, port1: Point, port2: Point) -> RRRPlaced:
        """B = P1 + (d + i h) q/|q| with d along and h across the line of the pivots."""
        q = port2.r - port1.r
        q2 = square(q)
        along, across = (self.l_a**2 - self.l_b**2) + q2, np.sqrt(self._spread(q2)) * self.variant
        a = vector(along / (2 * q2), across / (2 * q2)) * q
        return RRRPlaced(a, a - q)

    def rates(self, port1: Point, port2: Point, placed: RRRPlaced, method: Method) -> Rates:
        """V_B and its derivative are the same on both links: v1 + i omega_a a = v2 + i omega_b b."""
        solve = method(1j * placed.a, -1j * placed.b)
        x, y = solve(port2.v - port1.v)
        return Rates(x, y, *solve(port2.a - port1.a + x**2 * placed.a - y**2 * placed.b))

    def regularity(self, placed: RRRPlaced) -> Real:
        """|sin| of the angle between the links."""
        return np.abs(cross(placed.a, placed.b)) / (self.l_a * self.l_b)

    def _distance(self, port1: Point, port2: Point) -> float:
        return float(np.abs(port2.r - port1.r).item())

    def limit(self, a: int | str, b: int | str, port1: Point, port2: Point) -> str:
        """Stretched or folded, with the lengths."""
        most, least = self.l_a + self.l_b, abs(self.l_a - self.l_b)
        q = self._distance(port1, port2)
        if abs(q - most) < abs(q - least):
            return (
                f"links {a} and {b} are stretched: the distance of their outer pins reaches "
                f"l_{a} + l_{b} = {mm(self.l_a)} + {mm(self.l_b)} = {mm(most)}"
            )
        return (
            f"links {a} and {b} are folded: the distance of their outer pins falls to "
            f"|l_{a} - l_{b}| = |{mm(self.l_a)} - {mm(self.l_b)}| = {mm(least)}"
        )

    def gap(self, a: int | str, b: int | str, port1: Point, port2: Point) -> str:
        """The distance of the outer pins against the sum or difference of the lengths."""
        q, most, least = self._distance(port1, port2), self.l_a + self.l_b, abs(self.l_a - self.l_b)
        if q > most:
            return f"the outer pins are {mm(q)} apart, more than l_{a} + l_{b} = {mm(most)}"
        return f"the outer pins are {mm(q)} apart, less than |l_{a} - l_{b}| = {mm(least)}"

    def dead_point(self) -> str:
        """What makes a dead point."""
        return "both links stand in line, a change point from which the motion can go on in two ways"

    def alone(self) -> tuple[RRRMount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a."""
        return RRRMount(0j, 0j, complex(self.l_a), complex(self.l_b)), complex(self.l_a)
