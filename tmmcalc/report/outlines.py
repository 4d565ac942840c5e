"""Pieces of outlines: arcs and lines that are exact, cubics that keep a stated distance from what they stand for."""

from __future__ import annotations

from cmath import exp
from typing import NamedTuple

from tmmcalc.core.numerics.curves import Plane
from tmmcalc.core.records import record


class Cubics(NamedTuple):
    """Bezier cubics that share their ends."""

    control: Plane  # (n, 4)


class Bow(NamedTuple):
    """An arc, counter-clockwise."""

    centre: complex
    radius: float
    start: float  # [rad] from +X
    sweep: float  # [rad]

    @property
    def ends(self) -> tuple[complex, complex]:
        """First and last point."""
        return self._at(0.0), self._at(self.sweep)

    def _at(self, turn: float) -> complex:
        return self.centre + self.radius * exp(1j * (self.start + turn))


class Line(NamedTuple):
    """A straight line."""

    ends: tuple[complex, complex]


Piece = Cubics | Bow | Line


@record
class Outline:
    """A named chain of pieces, each of which begins where the one before it ends [m]."""

    name: str
    layer: str
    pieces: tuple[Piece, ...]
    polygon: Plane  # (n,) in chords that keep the tolerance; of a closed one the first point is not repeated
    closed: bool
