"""Dyad RPP: a pivoted block on a slider that itself slides on a guide (PPR is its mirror form).

      P1
       |  e2 = d e1            P1 = G + (s1 + i h1) e1 + (s2 + i h2) e2
    s2 |
G --s1-+------>  e1            one assembly; singular where d is parallel to the guide
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Plane, Point, Real, cross
from tmmcalc.linkage.dyads.base import Elements, Motions, Rates, Sites, Slides, carried, signed, slid
from tmmcalc.linkage.solvers import Method
from tmmcalc.linkage.structure import Group


class RPPPlaced(NamedTuple):
    """Placement: directions (unit), coordinates [m], the vector G -> P1 [m]."""

    e1: Plane
    e2: Plane
    s1: Real
    s2: Real
    offset: Plane


class RPPMount(NamedTuple):
    """RPP: both links keep a constant turn to the guide's link; b slides on it, a is pinned."""

    pin_a: complex
    line_b: complex  # point of b's outer line, in the axes of b
    turn_a: complex
    turn_b: complex
    shift_a: float
    shift_b: float
    inner: str
    outer: str
    signs: tuple[int, int]  # of the inner and of the outer joint

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: RPPPlaced, rates: Rates) -> None:
        """The base point of a is its pin, that of b its point on the guide."""
        a, b = at.links
        guide = motions[at.sources[1]]
        s1 = placed.s1 - self.shift_b
        motions[a] = carried(guide, self.turn_a, self.pin_a, at.port1)
        motions[b] = carried(guide, self.turn_b, self.line_b, slid(at.port2, s1, rates.x, rates.xx))
        slides[self.outer] = signed(self.signs[1], s1, rates.x, rates.xx)
        slides[self.inner] = signed(self.signs[0], placed.s2 - self.shift_a, rates.y, rates.yy)


class RPP(NamedTuple):
    """RPP with the inner direction ``d`` (unit, in guide axes) and the offsets ``h1``, ``h2`` [m]."""

    d: complex = 1j
    h1: float = 0.0
    h2: float = 0.0

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[RPP, RPPMount]:
        """The inner line stands at d to the guide; the pin is off the lines by h1 and h2."""
        d = elements.inner_b.direction / elements.outer_b.direction
        line, pin = elements.outer_b.along(elements.inner_b.point), elements.inner_a.along(elements.outer_a.point)
        mount = RPPMount(
            pin_a=elements.outer_a.point,
            line_b=elements.outer_b.point,
            turn_a=elements.port2.direction * d / elements.inner_a.direction,
            turn_b=elements.port2.direction / elements.outer_b.direction,
            shift_a=pin.real,
            shift_b=line.real,
            inner=group.inner[0],
            outer=group.outer[1],
            signs=(elements.inner_a.sign, elements.outer_b.sign),
        )
        return cls(d, line.imag, pin.imag), mount

    def margin(self, port1: Point, port2: Guide) -> Real:
        """Squared sine of the constant angle between the two lines."""
        return np.full(np.shape(port1.r), self.d.imag**2)

    def place(self, port1: Point, port2: Guide) -> RPPPlaced:
        """Oblique coordinates of P1 along the guide and along the inner line."""
        offset = port1.r - port2.r
        w = offset * np.conj(port2.e) - 1j * self.h1 - 1j * self.h2 * self.d
        s2 = w.imag / self.d.imag
        return RPPPlaced(port2.e, port2.e * self.d, w.real - s2 * self.d.real, s2, offset)

    def rates(self, port1: Point, port2: Guide, placed: RPPPlaced, method: Method) -> Rates:
        """v1 = transport + ds1 e1 + ds2 e2; accelerations have transport and Coriolis parts."""
        solve = method(placed.e1, placed.e2)
        v, a = port2.transport(placed.offset)
        x, y = solve(port1.v - v)
        sliding = x * placed.e1 + y * placed.e2
        return Rates(x, y, *solve(port1.a - a - 2j * port2.omega * sliding))

    def regularity(self, placed: RPPPlaced) -> Real:
        """|sin| of the constant angle between the two lines."""
        return np.abs(cross(placed.e1, placed.e2))

    def limit(self, a: int | str, b: int | str, port1: Point, port2: Guide) -> str:
        """Parallel lines of the slider, at every position or at none."""
        return f"the two lines of link {b} are parallel"

    def gap(self, a: int | str, b: int | str, port1: Point, port2: Guide) -> str:
        """Parallel lines of the slider."""
        return self.limit(a, b, port1, port2)

    def dead_point(self) -> str:
        """What makes a dead point."""
        return "the two lines of the slider are parallel"

    def alone(self) -> tuple[RPPMount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a."""
        return RPPMount(0j, 0j, self.d, 1 + 0j, 0.0, 0.0, "1", "2", (1, 1)), None
