"""The velocity and acceleration polygons of one position, to a round scale, with named vertices."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from tmmcalc.linkage.vectors import Polygon, Vector, VectorPolygons
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import SAMPLE
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import point_name, width
from tmmcalc.report.drawing.pens import MIDDLE, VECTORS
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

MARGIN = 11.0  # free border [mm]
SHORT = 1e-6  # a vector shorter than this, against the largest, is not drawn
HEAD = 3.0  # length of an arrowhead [mm]
HEIGHT = 2.5  # of words
KINDS: Mapping[str, str] = {
    "absolute": "absolute",
    "relative": "relative, of two points of a link",
    "normal": "normal part",
    "tangential": "tangential part",
    "sliding": "relative, of a slider on its guide",
    "coriolis": "Coriolis",
}


def draw_polygon(drawing: Drawing, box: Box, polygon: Polygon, fixed: tuple[str, ...]) -> Board:
    """Draw one polygon in a rectangle, as large as a round scale allows; returns the board."""
    tips = np.array(list(polygon.vertices.values()))
    board = Board(drawing, box, tips, MARGIN)
    size = float(np.max(np.abs(tips)))
    order = list(VECTORS)  # rays from the pole first, so that the parts are drawn over them
    for vector in sorted(polygon.vectors, key=lambda vector: order.index(vector.kind)):
        if abs(polygon.value(vector)) > SHORT * size:
            _draw(board, polygon, vector)
    board.circle(polygon.vertices[polygon.pole], 0.9, MIDDLE, level=25)
    for place, names in _together(polygon, fixed, size).items():
        at = board.paper([place])
        board.labels.put(names, at, height=3.0, prefer=place or -1 - 1j, gaps=(1.1, 2.0, 3.2, 4.6))
    return board


def _draw(board: Board, polygon: Polygon, vector: Vector) -> None:
    tail, value = polygon.vertices[vector.tail], polygon.value(vector)
    level = 5 + list(VECTORS).index(vector.kind)
    board.vector(tail, tail + value, VECTORS[vector.kind], HEAD, level=level)


def _together(polygon: Polygon, fixed: tuple[str, ...], size: float) -> dict[complex, str]:
    """Vertices that lie in one place share a label; points of the frame stand in brackets beside the pole."""
    names: dict[complex, list[str]] = {}
    for name, tip in polygon.vertices.items():
        place = next((other for other in names if abs(other - tip) <= 2e-3 * size), tip)
        names.setdefault(place, []).append("$π$" if name == "pi" else point_name(name))
    pole = polygon.vertices[polygon.pole]
    names[pole].extend(f"({', '.join(map(point_name, group))})" for group in [fixed] if group)
    return {place: ", ".join(group) for place, group in names.items()}


def scale_note(letter: str, mu: float) -> str:
    """The scale as it is written beside a polygon."""
    unit = "m/s" if letter == "v" else "m/s²"
    return f"$μ_{letter}$ = {number(mu, 4)} ({unit})/mm"


def rotation_notes(vectors: VectorPolygons) -> list[str]:
    """One line a turning link: omega and eps with their senses."""
    return [
        f"link {link}:  {_turning('ω', omega, 'rad/s')},  {_turning('ε', vectors.eps[link], 'rad/s²')}"
        for link, omega in vectors.omega.items()
    ]


def _turning(letter: str, value: float, unit: str) -> str:
    sense = "" if math.isclose(value, 0.0, abs_tol=1e-12) else " (ccw)" if value > 0 else " (cw)"
    return f"${letter}$ = {number(abs(value) if sense else 0.0, 5)} {unit}{sense}"


def draw_notes(drawing: Drawing, box: Box, vectors: VectorPolygons) -> None:
    """Kinds of vectors and rotations of links, in columns."""
    used = {v.kind for polygon in (vectors.velocity, vectors.acceleration) for v in polygon.vectors}
    kinds = [kind for kind in VECTORS if kind in used]
    wide = max((SAMPLE + 2 + width(KINDS[kind], HEIGHT) for kind in kinds), default=1.0) + 5.0
    columns = max(1, int(box.width / wide))
    at = complex(box.left, box.top - 2.0)
    for k, kind in enumerate(kinds):
        here = at + complex(k % columns * wide, -(k // columns) * 2 * HEIGHT)
        drawing.vector(here, here + SAMPLE, VECTORS[kind])
        drawing.add(Words(here + SAMPLE + 2, KINDS[kind], HEIGHT, -1))
    at -= 1j * (math.ceil(len(kinds) / columns) * 2 * HEIGHT + 1.0)
    notes = rotation_notes(vectors)
    wide = max((width(note, HEIGHT) for note in notes), default=1.0) + 8.0
    columns = max(1, int(box.width / wide))
    for k, note in enumerate(notes):
        here = at + complex(k % columns * wide, -(k // columns) * 1.9 * HEIGHT)
        drawing.add(Words(here, note, HEIGHT, -1))
