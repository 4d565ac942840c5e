"""Polygons of vectors as they are told: named vertices, and the vectors between them."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record

Kind = Literal["absolute", "relative", "normal", "tangential", "sliding", "coriolis", "special"]


@record
class Vector:
    """A vector of a polygon from one vertex to another; ``link`` is the one that turns, or the slider.

    It is the motion of ``point``, against ``base`` where that is given: v_B, v_BA, a_BA^n, a_A2A3^k.
    """

    tail: str
    head: str
    kind: Kind
    link: int
    point: str
    base: str = ""


@record
class Polygon:
    """Vertices by name, the pole among them at 0, and the vectors; [m/s] or [m/s^2]."""

    pole: str
    vertices: dict[str, complex]
    vectors: tuple[Vector, ...]

    def value(self, vector: Vector) -> complex:
        """The vector itself, head less tail."""
        return self.vertices[vector.head] - self.vertices[vector.tail]


@record
class PolygonOverAll:
    """The polygon of n positions: vertices (n,) by name, and the vectors, which are the same at all of them."""

    pole: str
    vertices: dict[str, Plane]
    vectors: tuple[Vector, ...]


@record
class VectorPolygons:
    """Both polygons of a position, the points in the pole, and omega [rad/s] and eps [rad/s^2] of turning links."""

    position: int
    velocity: Polygon
    acceleration: Polygon
    fixed: tuple[str, ...]
    omega: dict[int, float]
    eps: dict[int, float]
