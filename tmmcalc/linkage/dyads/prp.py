"""Dyad PRP: two sliders on two guides, joined by a revolute joint.

G1 ---s1---[B]--->  e1         B = G1 + (s1 + i h1) e1 = G2 + (s2 + i h2) e2
           /
          / s2
        G2                     one assembly; singular where the guides are parallel
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Plane, Point, Real, cross
from tmmcalc.linkage.dyads.base import Elements, Motions, Rates, Sites, Slides, carried, signed, slid
from tmmcalc.linkage.solvers import Method
from tmmcalc.linkage.structure import Group


class PRPPlaced(NamedTuple):
    """Placement: directions (unit), coordinates [m], vectors G1 -> B and G2 -> B [m], and B [m]."""

    e1: Plane
    e2: Plane
    s1: Real
    s2: Real
    offset1: Plane
    offset2: Plane
    inner: Plane


class PRPMount(NamedTuple):
    """PRP: two sliders, each turning with its own guide; the base point of both is the inner pin."""

    inner_a: complex
    inner_b: complex
    turn_a: complex
    turn_b: complex
    shift_a: float
    shift_b: float
    outer: tuple[str, str]
    signs: tuple[int, int]

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: PRPPlaced, rates: Rates) -> None:
        """The inner pin slides on the first guide."""
        a, b = at.links
        on_guide = Guide(*_offset(at.port1, placed.offset1 - placed.s1 * placed.e1), *at.port1[3:])
        pin = slid(on_guide, placed.s1, rates.x, rates.xx)
        motions[a] = carried(motions[at.sources[0]], self.turn_a, self.inner_a, pin)
        motions[b] = carried(motions[at.sources[1]], self.turn_b, self.inner_b, pin)
        slides[self.outer[0]] = signed(self.signs[0], placed.s1 - self.shift_a, rates.x, rates.xx)
        slides[self.outer[1]] = signed(self.signs[1], placed.s2 - self.shift_b, rates.y, rates.yy)


def _offset(guide: Guide, x: Plane) -> Point:
    """State of the point of the guide's link at the vector x from its reference point."""
    return Point(guide.r + x, *guide.transport(x))


class PRP(NamedTuple):
    """PRP with the offsets ``h1``, ``h2`` [m] of the inner pin from the guide lines."""

    h1: float = 0.0
    h2: float = 0.0

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[PRP, PRPMount]:
        """The inner pin stands off both lines by h1 and h2."""
        pin_a, pin_b = elements.outer_a.along(elements.inner_a.point), elements.outer_b.along(elements.inner_b.point)
        mount = PRPMount(
            inner_a=elements.inner_a.point,
            inner_b=elements.inner_b.point,
            turn_a=elements.port1.direction / elements.outer_a.direction,
            turn_b=elements.port2.direction / elements.outer_b.direction,
            shift_a=pin_a.real,
            shift_b=pin_b.real,
            outer=(group.outer[0], group.outer[1]),
            signs=(elements.outer_a.sign, elements.outer_b.sign),
        )
        return cls(pin_a.imag, pin_b.imag), mount

    def margin(self, port1: Guide, port2: Guide) -> Real:
        """Two lines always meet unless parallel: squared sine of the angle between them."""
        return cross(port1.e, port2.e) ** 2

    def place(self, port1: Guide, port2: Guide) -> PRPPlaced:
        """Meeting point of the two offset lines."""
        gap = (port2.r + 1j * self.h2 * port2.e) - (port1.r + 1j * self.h1 * port1.e)
        determinant = cross(port1.e, port2.e)
        s1 = cross(gap, port2.e) / determinant
        s2 = cross(gap, port1.e) / determinant
        offset1 = (s1 + 1j * self.h1) * port1.e
        inner = port1.r + offset1
        return PRPPlaced(port1.e, port2.e, s1, s2, offset1, inner - port2.r, inner)

    def rates(self, port1: Guide, port2: Guide, placed: PRPPlaced, method: Method) -> Rates:
        """B is the same on both guides: transport1 + ds1 e1 = transport2 + ds2 e2."""
        solve = method(placed.e1, -placed.e2)
        (v1, a1), (v2, a2) = port1.transport(placed.offset1), port2.transport(placed.offset2)
        x, y = solve(v2 - v1)
        return Rates(x, y, *solve(a2 + _coriolis(port2, y) - (a1 + _coriolis(port1, x))))

    def regularity(self, placed: PRPPlaced) -> Real:
        """|sin| of the angle between the guides."""
        return np.abs(cross(placed.e1, placed.e2))

    def limit(self, a: int | str, b: int | str, port1: Guide, port2: Guide) -> str:
        """Parallel guides, the only way in which two lines fail to meet."""
        return f"the guides of links {a} and {b} are parallel"

    def gap(self, a: int | str, b: int | str, port1: Guide, port2: Guide) -> str:
        """Parallel guides."""
        return self.limit(a, b, port1, port2)

    def dead_point(self) -> str:
        """What makes a dead point."""
        return "the two guides are parallel"

    def alone(self) -> tuple[PRPMount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a."""
        return PRPMount(0j, 0j, 1 + 0j, 1 + 0j, 0.0, 0.0, ("0", "2"), (1, 1)), 0j


def _coriolis(guide: Guide, ds: Real) -> Plane:
    """Acceleration of Coriolis of a point that slides with ds."""
    return 2j * (guide.omega * ds) * guide.e
