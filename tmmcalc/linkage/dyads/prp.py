"""Dyad PRP: two sliders on two guides, joined by a revolute joint.

G1 ---s1---[B]--->  e1         B = G1 + (s1 + i h1) e1 = G2 + (s2 + i h2) e2
           /
          / s2
        G2                     one assembly; singular where the guides are parallel
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Plane, Real, cross


class PRPPlaced(NamedTuple):
    """Placement: directions (unit), coordinates [m], vectors G1 -> B and G2 -> B [m], and B [m]."""

    e1: Plane
    e2: Plane
    s1: Real
    s2: Real
    offset1: Plane
    offset2: Plane
    inner: Plane


class PRP(NamedTuple):
    """PRP with the offsets ``h1``, ``h2`` [m] of the inner pin from the guide lines."""

    h1: float = 0.0
    h2: float = 0.0

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

    def columns(self, placed: PRPPlaced) -> tuple[Plane, Plane]:
        """transport1 + ds1 e1 = transport2 + ds2 e2."""
        return placed.e1, -placed.e2

    def velocity(self, port1: Guide, port2: Guide, placed: PRPPlaced) -> Plane:
        """Difference of the transport velocities of B."""
        return (port2.v + 1j * port2.omega * placed.offset2) - (port1.v + 1j * port1.omega * placed.offset1)

    def acceleration(self, port1: Guide, port2: Guide, placed: PRPPlaced, x: Real, y: Real) -> Plane:
        """Difference of the transport and Coriolis accelerations of B."""
        return _sliding(port2, placed.offset2, y) - _sliding(port1, placed.offset1, x)

    def regularity(self, placed: PRPPlaced, reach: float) -> Real:
        """|sin| of the angle between the guides."""
        return np.abs(cross(placed.e1, placed.e2))

    def transmission(self, placed: PRPPlaced) -> Real:
        """|sin| of the angle between the guides."""
        return self.regularity(placed, 0.0)

    def limit(self, a: int, b: int, port1: Guide, port2: Guide) -> str:
        """Parallel guides, the only way in which two lines fail to meet."""
        return f"the guides of links {a} and {b} are parallel"

    def gap(self, a: int, b: int, port1: Guide, port2: Guide) -> str:
        """Parallel guides."""
        return self.limit(a, b, port1, port2)


def _sliding(guide: Guide, offset: Plane, ds: Real) -> Plane:
    """Acceleration of a point that slides with ds, without its dds part."""
    return guide.a + (1j * guide.eps - guide.omega**2) * offset + 2j * (guide.omega * ds) * guide.e
