"""Dyad RRP: a connecting rod and a slider (PRR is its mirror form).

           P1
             \\ a  length l
              \\
        ------[B]---->  e     B stands at the distance h to the left of the guide line
          G  s

Variant +1 ("right"): B lies ahead of P1 in the direction of the guide; -1 ("left"): behind it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Parts, Plane, Point, Real, rotated, vector
from tmmcalc.linkage.dyads.base import Elements, Motions, Rates, Sites, Slides, carried, length_of, mm, signed
from tmmcalc.linkage.solvers import Method
from tmmcalc.linkage.structure import Group


class RRPPlaced(NamedTuple):
    """Placement: a = P1 -> B [m]; in guide axes a = (along + i across) e; slider coordinate s [m]."""

    a: Plane
    along: Real
    across: Real
    s: Real
    offset: Plane  # G -> B [m]


class RRPMount(NamedTuple):
    """RRP: rod a turns about its outer pin, slider b follows the guide; its base point is the inner pin."""

    pin_a: complex
    vector_a: complex
    inner_a: complex
    inner_b: complex
    turn: complex  # axes of b against the axes of the source link, unit
    shift: float  # from the slider's line point to the inner pin, along the guide [m]
    outer: str
    sign: int

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: RRPPlaced, rates: Rates) -> None:
        """The rod carries the inner pin, the pin carries the slider."""
        a, b = at.links
        motions[a] = rotated(self.pin_a, at.port1, placed.a / self.vector_a, rates.x, rates.xx)
        pin = motions[a].point(self.inner_a)
        motions[b] = carried(motions[at.sources[1]], self.turn, self.inner_b, pin)
        slides[self.outer] = signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


class RRP(NamedTuple):
    """RRP with rod length ``l`` [m], offset ``h`` [m] and the variant (textbook 2.5.2, (2.2) to (2.6))."""

    l: float
    h: float = 0.0
    variant: int = 1

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[RRP, RRPMount]:
        """The rod is the vector between its pins; the inner pin stands off the line of the slider by h."""
        vector = elements.inner_a.point - elements.outer_a.point
        pin = elements.outer_b.along(elements.inner_b.point)
        mount = RRPMount(
            pin_a=elements.outer_a.point,
            vector_a=vector,
            inner_a=elements.inner_a.point,
            inner_b=elements.inner_b.point,
            turn=elements.port2.direction / elements.outer_b.direction,
            shift=pin.real,
            outer=group.outer[1],
            sign=elements.outer_b.sign,
        )
        return cls(length_of(vector, group.links[0], group), pin.imag, variant), mount

    def _in_guide(self, port1: Point, port2: Guide) -> Plane:
        return (port1.r - port2.r) * np.conj(port2.e)

    def margin(self, port1: Point, port2: Guide) -> Real:
        """Squared cosine of the angle between rod and guide; negative where P1 is farther than l from the line."""
        across = self.h - self._in_guide(port1, port2).imag
        return (self.l - across) * (self.l + across) / self.l**2

    def place(self, port1: Point, port2: Guide) -> RRPPlaced:
        """The rod spans the distance from P1 to the slider's line."""
        z = self._in_guide(port1, port2)
        across = self.h - z.imag
        along = np.sqrt((self.l - across) * (self.l + across)) * self.variant
        s = z.real + along
        a = vector(along, across) * port2.e
        return RRPPlaced(a, along, across, s, port1.r + a - port2.r)

    def rates(self, port1: Point, port2: Guide, placed: RRPPlaced, method: Method) -> Rates:
        """ds e - i omega_a a = v1 - transport, divided by e; accelerations have Coriolis and the rod's normal part."""
        solve = method(Parts(placed.across, -placed.along), 1)
        (v, a), back = port2.transport(placed.offset), np.conj(port2.e)
        x, y = solve((port1.v - v) * back)
        w, turning = (port1.a - a) * back, x * x
        across = w.imag - turning * placed.across
        if port2.turns:
            across = across - 2 * port2.omega * y
        return Rates(x, y, *solve(Parts(w.real - turning * placed.along, across)))

    def regularity(self, placed: RRPPlaced) -> Real:
        """|cos| of the angle between rod and guide."""
        return np.abs(placed.along) / self.l

    def limit(self, a: int | str, b: int | str, port1: Point, port2: Guide) -> str:
        """The rod across the guide."""
        return (
            f"link {a} stands perpendicular to the guide of link {b}: the distance of its outer pin from the pin's "
            f"line reaches l_{a} = {mm(self.l)}"
        )

    def gap(self, a: int | str, b: int | str, port1: Point, port2: Guide) -> str:
        """The distance of the outer pin from the line against the rod's length."""
        off = float(np.abs(self.h - self._in_guide(port1, port2).imag).item())
        return f"the pin is {mm(off)} off its line, more than l_{a} = {mm(self.l)}"

    def dead_point(self) -> str:
        """What makes a dead point."""
        return "the rod stands across the guide, a change point from which the motion can go on in two ways"

    def alone(self) -> tuple[RRPMount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a."""
        return RRPMount(0j, complex(self.l), complex(self.l), 0j, 1 + 0j, 0.0, "2", 1), complex(self.l)
