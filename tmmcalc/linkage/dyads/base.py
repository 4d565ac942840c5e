"""What a dyad must provide.

A dyad is a two-link Assur group: an inner joint between its links a and b and one outer joint of each
with the chain that is already solved. One file a kind: RRR, RRP, RPR, PRP, RPP (the letters are the
outer joint of a, the inner joint, the outer joint of b; PRR and PPR are RRP and RPP with a and b
exchanged). A kind is a named tuple of its metric with

1. ``margin(port1, port2)``: a smooth function of the ports, negative exactly where the dyad does not
   assemble [-];
2. ``place(port1, port2)``: stage 1, positions, for the chosen variant;
3. ``columns``, ``velocity``, ``acceleration``: the plane vector equation c1 x + c2 y = w of stages 2, 3;
4. ``regularity``: |sin| of the angle between the columns, 0 at a dead point; ``transmission``: the sine
   of the transmission angle;
5. ``limit`` and ``gap``: in words, what holds the links at a limit position, and by how much they miss each other.

Ports are `Point` for an outer revolute and `Guide` for an outer prismatic joint.
"""

from __future__ import annotations

from typing import Any, Protocol

from tmmcalc.core.plane import Plane, Real


class Dyad(Protocol):
    """One kind of dyad with its metric; ports and placements are those of the kind."""

    def margin(self, port1: Any, port2: Any) -> Real:
        """Smooth function, negative exactly where the links do not reach [-]; shape (n,)."""

    def place(self, port1: Any, port2: Any) -> Any:
        """Stage 1: the placement of both links for the chosen assembly variant."""

    def columns(self, placed: Any) -> tuple[Plane, Plane]:
        """Columns c1, c2 of the rates."""

    def velocity(self, port1: Any, port2: Any, placed: Any) -> Plane:
        """Right-hand side of the velocity equation."""

    def acceleration(self, port1: Any, port2: Any, placed: Any, x: Real, y: Real) -> Plane:
        """Right-hand side of the acceleration equation, with the velocity rates x, y."""

    def regularity(self, placed: Any, reach: float) -> Real:
        """Distance from a dead point, 1 the best, 0 singular; ``reach`` [m] is the largest pin distance."""

    def transmission(self, placed: Any) -> Real:
        """Sine of the transmission angle; its complement is the pressure angle."""

    def limit(self, a: int, b: int, port1: Any, port2: Any) -> str:
        """What holds the links numbered a and b at a limit position; ports at that position."""

    def gap(self, a: int, b: int, port1: Any, port2: Any) -> str:
        """By how much the links numbered a and b miss each other; ports at one position."""


def mm(length: float) -> str:
    """A length [m] as text."""
    return f"{length * 1000:.7g} mm"
