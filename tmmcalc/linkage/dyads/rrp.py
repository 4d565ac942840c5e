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

from tmmcalc.core.plane import Guide, Plane, Point, Real
from tmmcalc.linkage.dyads.base import mm


class RRPPlaced(NamedTuple):
    """Placement: a = P1 -> B [m]; in guide axes a = (along + i across) e; slider coordinate s [m]."""

    a: Plane
    along: Real
    across: Real
    s: Real
    offset: Plane  # G -> B [m]


class RRP(NamedTuple):
    """RRP with rod length ``l`` [m], offset ``h`` [m] and the variant (textbook 2.5.2, (2.2) to (2.6))."""

    l: float
    h: float = 0.0
    variant: int = 1

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
        local = np.empty(across.shape, z.dtype)
        local.real, local.imag = along, across
        a = local * port2.e
        return RRPPlaced(a, along, across, s, port1.r + a - port2.r)

    def columns(self, placed: RRPPlaced) -> tuple[Plane, Plane]:
        """v1 + i omega_a a = transport + ds e, divided by e."""
        return 1j * placed.along - placed.across, np.array(-1 + 0j)

    def velocity(self, port1: Point, port2: Guide, placed: RRPPlaced) -> Plane:
        """Transport velocity of B less the velocity of P1, in guide axes."""
        return (port2.v + 1j * port2.omega * placed.offset - port1.v) * np.conj(port2.e)

    def acceleration(self, port1: Point, port2: Guide, placed: RRPPlaced, x: Real, y: Real) -> Plane:
        """Transport and Coriolis acceleration of B less that of P1, and the rod's normal part, in guide axes."""
        transport = port2.a + (1j * port2.eps - port2.omega**2) * placed.offset - port1.a
        relative: Plane = x**2 * placed.along + 1j * (x**2 * placed.across + 2 * port2.omega * y)
        return transport * np.conj(port2.e) + relative

    def regularity(self, placed: RRPPlaced, reach: float) -> Real:
        """|cos| of the angle between rod and guide."""
        return np.abs(placed.along) / self.l

    def transmission(self, placed: RRPPlaced) -> Real:
        """|cos| of the angle between rod and guide: the rod's pressure angle is its complement."""
        return self.regularity(placed, 0.0)

    def limit(self, a: int, b: int, port1: Point, port2: Guide) -> str:
        """The rod across the guide."""
        return (
            f"link {a} stands perpendicular to the guide of link {b}: the distance of its outer pin from the pin's "
            f"line reaches l_{a} = {mm(self.l)}"
        )

    def gap(self, a: int, b: int, port1: Point, port2: Guide) -> str:
        """The distance of the outer pin from the line against the rod's length."""
        off = float(np.abs(self.h - self._in_guide(port1, port2).imag).item())
        return f"the pin is {mm(off)} off its line, more than l_{a} = {mm(self.l)}"
