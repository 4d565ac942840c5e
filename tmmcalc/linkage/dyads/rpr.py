"""Dyad RPR: a slider block on a slotted link, or a piston rod in an oscillating cylinder.

          P1
         --[ ]-------->  e      P1 = P2 + (s + i h) e
          /  s
        P2

Variant +1: P1 lies ahead of P2 in the direction of the line; -1: behind. With h = 0 the two variants are
one geometry with the direction reversed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Parts, Plane, Point, Real, rotated, square
from tmmcalc.linkage.dyads.base import Elements, Motions, Rates, Sites, Slides, carried, mm, signed
from tmmcalc.linkage.solvers import Method
from tmmcalc.linkage.structure import Group


class RPRPlaced(NamedTuple):
    """Placement: q = P2 -> P1 [m], direction e (unit), distance s along it [m]."""

    q: Plane
    e: Plane
    s: Real


class RPRMount(NamedTuple):
    """RPR: both links turn alike, each about its own outer pin."""

    pin_a: complex
    pin_b: complex
    axis_b: complex  # direction of the line in the axes of b, unit
    turn: complex  # axes of a against the axes of b, unit
    shift: float
    inner: str
    sign: int

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: RPRPlaced, rates: Rates) -> None:
        """Link b carries the direction, link a keeps a constant turn to it."""
        a, b = at.links
        u = placed.e if self.axis_b == 1 else placed.e / self.axis_b
        motions[b] = rotated(self.pin_b, at.port2, u, rates.x, rates.xx)
        motions[a] = carried(motions[b], self.turn, self.pin_a, at.port1)
        slides[self.inner] = signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


class RPR(NamedTuple):
    """RPR with the offset ``h`` [m] of the line from pivot to pivot and the variant (textbook 2.5.4, (2.19))."""

    h: float = 0.0
    variant: int = 1

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[RPR, RPRMount]:
        """Variant +1 puts the slider's pivot ahead of the guide link's, whichever of the two is link a."""
        shift = elements.inner_a.along(elements.outer_a.point) - elements.inner_b.along(elements.outer_b.point)
        mount = RPRMount(
            pin_a=elements.outer_a.point,
            pin_b=elements.outer_b.point,
            axis_b=elements.inner_b.direction,
            turn=elements.inner_b.direction / elements.inner_a.direction,
            shift=shift.real,
            inner=group.inner[0],
            sign=elements.inner_a.sign,
        )
        return cls(shift.imag, variant * elements.inner_a.sign), mount

    def margin(self, port1: Point, port2: Point) -> Real:
        """(Q^2 - h^2)/Q^2; negative where the pivots are nearer than the offset."""
        q2 = square(port1.r - port2.r)
        if self.h == 0:
            return np.ones_like(q2)
        return (q2 - self.h**2) / np.maximum(q2, self.h**2 * 1e-6)

    def place(self, port1: Point, port2: Point) -> RPRPlaced:
        """The line is turned from q by the angle that the offset demands."""
        q = port1.r - port2.r
        q2 = square(q)
        s = np.sqrt(q2 - self.h**2) * self.variant
        if self.h == 0:
            return RPRPlaced(q, q / s, s)
        return RPRPlaced(q, q * (s - 1j * self.h) / q2, s)

    def rates(self, port1: Point, port2: Point, placed: RPRPlaced, method: Method) -> Rates:
        """i omega (s + i h) e + ds e = v1 - v2, divided by e; accelerations have Coriolis and the normal part."""
        solve, back = method(Parts(-self.h, placed.s), 1), np.conj(placed.e)
        x, y = solve((port1.v - port2.v) * back)
        w = (port1.a - port2.a) * back
        return Rates(x, y, *solve(Parts(w.real + x * x * placed.s, w.imag + x * (x * self.h - 2 * y))))

    def regularity(self, placed: RPRPlaced) -> Real:
        """|s| over the largest distance of the pivots: the pin on the pivot is singular."""
        return np.abs(placed.s) / float(np.max(np.abs(placed.q)))

    def limit(self, a: int | str, b: int | str, port1: Point, port2: Point) -> str:
        """The pivots at the distance of the offset."""
        return f"the pivots of links {a} and {b} come as near as the offset of the guide, {mm(abs(self.h))}"

    def gap(self, a: int | str, b: int | str, port1: Point, port2: Point) -> str:
        """The pivots nearer than the offset."""
        return f"the pivots are always nearer to each other than the offset {mm(abs(self.h))} of the guide"

    def dead_point(self) -> str:
        """What makes a dead point."""
        return "the pivots come as near as the guide's offset allows, which leaves its direction open"

    def alone(self) -> tuple[RPRMount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a."""
        return RPRMount(0j, 0j, 1 + 0j, 1 + 0j, 0.0, "1", 1), None
