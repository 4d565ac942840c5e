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


class RPPPlaced(NamedTuple):
    """Placement: directions (unit), coordinates [m], the vector G -> P1 [m]."""

    e1: Plane
    e2: Plane
    s1: Real
    s2: Real
    offset: Plane


class RPP(NamedTuple):
    """RPP with the inner direction ``d`` (unit, in guide axes) and the offsets ``h1``, ``h2`` [m]."""

    d: complex = 1j
    h1: float = 0.0
    h2: float = 0.0

    def margin(self, port1: Point, port2: Guide) -> Real:
        """Squared sine of the constant angle between the two lines."""
        return np.full(np.shape(port1.r), self.d.imag**2)

    def place(self, port1: Point, port2: Guide) -> RPPPlaced:
        """Oblique coordinates of P1 along the guide and along the inner line."""
        offset = port1.r - port2.r
        w = offset * np.conj(port2.e) - 1j * self.h1 - 1j * self.h2 * self.d
        s2 = w.imag / self.d.imag
        return RPPPlaced(port2.e, port2.e * self.d, w.real - s2 * self.d.real, s2, offset)

    def columns(self, placed: RPPPlaced) -> tuple[Plane, Plane]:
        """v1 = transport + ds1 e1 + ds2 e2."""
        return placed.e1, placed.e2

    def velocity(self, port1: Point, port2: Guide, placed: RPPPlaced) -> Plane:
        """Velocity of P1 less the transport velocity there."""
        return port1.v - port2.v - 1j * port2.omega * placed.offset

    def acceleration(self, port1: Point, port2: Guide, placed: RPPPlaced, x: Real, y: Real) -> Plane:
        """Acceleration of P1 less transport and Coriolis parts."""
        sliding = x * placed.e1 + y * placed.e2
        transport = port2.a + (1j * port2.eps - port2.omega**2) * placed.offset
        return port1.a - transport - 2j * port2.omega * sliding

    def regularity(self, placed: RPPPlaced, reach: float) -> Real:
        """|sin| of the constant angle between the two lines."""
        return np.abs(cross(placed.e1, placed.e2))

    def transmission(self, placed: RPPPlaced) -> Real:
        """|sin| of the constant angle between the two lines."""
        return self.regularity(placed, 0.0)

    def limit(self, a: int, b: int, port1: Point, port2: Guide) -> str:
        """Parallel lines of the slider, at every position or at none."""
        return f"the two lines of link {b} are parallel"

    def gap(self, a: int, b: int, port1: Point, port2: Guide) -> str:
        """Parallel lines of the slider."""
        return self.limit(a, b, port1, port2)
