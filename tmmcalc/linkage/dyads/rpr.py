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

from tmmcalc.core.plane import Plane, Point, Real, square
from tmmcalc.linkage.dyads.base import mm


class RPRPlaced(NamedTuple):
    """Placement: q = P2 -> P1 [m], direction e (unit), distance s along it [m]."""

    q: Plane
    e: Plane
    s: Real


class RPR(NamedTuple):
    """RPR with the offset ``h`` [m] of the line from pivot to pivot and the variant (textbook 2.5.4, (2.19))."""

    h: float = 0.0
    variant: int = 1

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

    def columns(self, placed: RPRPlaced) -> tuple[Plane, Plane]:
        """v1 = v2 + i omega q + ds e."""
        return 1j * placed.q, placed.e

    def velocity(self, port1: Point, port2: Point, placed: RPRPlaced) -> Plane:
        """Relative velocity of the pivots."""
        return port1.v - port2.v

    def acceleration(self, port1: Point, port2: Point, placed: RPRPlaced, x: Real, y: Real) -> Plane:
        """Relative acceleration of the pivots less normal and Coriolis parts."""
        return port1.a - port2.a + x**2 * placed.q - 2j * (x * y) * placed.e

    def regularity(self, placed: RPRPlaced, reach: float) -> Real:
        """|s| over the largest distance of the pivots: the pin on the pivot is singular."""
        return np.abs(placed.s) / reach

    def transmission(self, placed: RPRPlaced) -> Real:
        """|s|/Q, the cosine of the pressure angle between the slot's normal and the pin's circle."""
        return np.abs(placed.s) / np.abs(placed.q)

    def limit(self, a: int, b: int, port1: Point, port2: Point) -> str:
        """The pivots at the distance of the offset."""
        return f"the pivots of links {a} and {b} come as near as the offset of the guide, {mm(abs(self.h))}"

    def gap(self, a: int, b: int, port1: Point, port2: Point) -> str:
        """The pivots nearer than the offset."""
        return f"the pivots are always nearer to each other than the offset {mm(abs(self.h))} of the guide"
