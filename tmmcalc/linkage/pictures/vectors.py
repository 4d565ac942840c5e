"""The plan of velocities or of accelerations of one position: named vertices, every segment with its designation."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from tmmcalc.linkage.vectors import Polygon, Vector
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import NUMBERED, point_name
from tmmcalc.report.drawing.pens import MIDDLE, VECTORS
from tmmcalc.report.drawing.scales import standard_scale
from tmmcalc.report.drawing.shapes import Drawing

MARGIN = 9.0  # free border [mm]
SHORT = 1e-6  # a vector shorter than this, against the largest, is nothing
SPECK = 0.4  # and a segment shorter than this has no designation [mm]
HEAD = 2.8  # length of an arrowhead [mm]
VERTEX, DESIGNATION = 3.0, 2.3  # height of names [mm]
AT = (0.55, 0.7, 0.4, 0.82, 0.28)  # where along a segment its designation may stand
SUPERSCRIPTS = {"normal": "n", "tangential": "t", "coriolis": "K"}
SPECIAL = re.compile(r"([Ww])(\d+)_(\d+)_(\d+)")  # a special point of a basic link on the lines of two legs


def draw_polygon(
    drawing: Drawing, box: Box, polygon: Polygon, letter: str, fixed: tuple[str, ...], mu: float = 0.0
) -> Board:
    """Draw a plan, of ``v`` or ``a``, in a rectangle: to the scale ``mu``, or as large as a standard one allows."""
    tips = np.array(list(polygon.vertices.values()))
    board = Board(drawing, box, tips, MARGIN, mu, scale=standard_scale)
    drawn = drawn_vectors(polygon)
    for vector in drawn:
        _draw(board, polygon, vector)
    board.circle(polygon.vertices[polygon.pole], 0.9, MIDDLE, level=25)
    name_vertices(board, polygon, fixed)
    ends = {vector: board.paper(_ends(polygon, vector)).tolist() for vector in drawn}
    for vector in drawn:
        others = [ends[other] for other in drawn if other is not vector]
        _designate(board, vector, letter, ends[vector], others)
    return board


def drawn_vectors(polygon: Polygon) -> list[Vector]:
    """The vectors that are something: rays from the pole first, so that the parts are drawn over them.

    A special point in the pole has no segments, for they would lie on the rays.
    """
    size = max(map(abs, polygon.vertices.values()))
    order = list(VECTORS)

    def seen(vector: Vector) -> bool:
        at_pole = vector.kind == "special" and abs(polygon.vertices[vector.head]) <= SHORT * size
        return not at_pole and abs(polygon.value(vector)) > SHORT * size

    return sorted(filter(seen, polygon.vectors), key=lambda vector: order.index(vector.kind))


def designation(vector: Vector, letter: str) -> str:
    """The sign of a vector of a plan of ``v`` or ``a``.

    >>> designation(Vector("a", "b", "relative", 2, "B", "A"), "v")
    '$v_{BA}$'
    >>> designation(Vector("a", "n3", "normal", 3, "B2", "A"), "a")
    '$a^{n}_{B_{2}A}$'
    """
    above = SUPERSCRIPTS.get(vector.kind, "r" if vector.kind == "sliding" and letter == "a" else "")
    names = [_index(name) for name in (vector.point, vector.base) if name]
    joint = (
        "" if all(len(name) == 1 or NUMBERED.fullmatch(name) for name in (vector.point, vector.base) if name) else ","
    )
    return f"${letter}{f'^{{{above}}}' if above else ''}_{{{joint.join(names)}}}$"


def lettered(name: str) -> tuple[str, str]:
    """The letter and the index of a name of a point or a vertex, a special point with its legs in brackets.

    >>> lettered("W2_3_4"), lettered("B2"), lettered("pivot")
    (('W', '2(3,4)'), ('B', '2'), ('pivot', ''))
    """
    if found := SPECIAL.fullmatch(name):
        return found[1], f"{found[2]}({found[3]},{found[4]})"
    return (found[1], found[2]) if (found := NUMBERED.fullmatch(name)) else (name, "")


def _index(name: str) -> str:
    """The name of a point as it stands in an index."""
    letter, index = lettered(name)
    if index:
        return f"{letter}_{{{index}}}"
    formula = point_name(name)
    return formula.strip("$") if formula.startswith("$") else name.replace("_", " ")


def vertex_name(name: str) -> str:
    """The name of a vertex, italic, with its number as an index."""
    if name == "pi":
        return "$π$"
    return f"${_index(name)}$" if lettered(name)[1] else point_name(name)


def _ends(polygon: Polygon, vector: Vector) -> list[complex]:
    return [polygon.vertices[vector.tail], polygon.vertices[vector.head]]


def _draw(board: Board, polygon: Polygon, vector: Vector) -> None:
    level = 5 + list(VECTORS).index(vector.kind)
    tail, head = _ends(polygon, vector)
    board.vector(tail, head, VECTORS[vector.kind], HEAD, level=level)


def _designate(board: Board, vector: Vector, letter: str, own: Sequence[complex], others: list[list[complex]]) -> None:
    """The designation of a segment beside it."""
    across = own[1] - own[0]
    if abs(across) < SPECK:
        return
    board.labels.put(
        designation(vector, letter),
        [own[0] + t * across for t in AT],
        height=DESIGNATION,
        colour=VECTORS[vector.kind].colour,
        prefer=1j * across,
        gaps=(0.7, 1.1, 1.7, 2.5),
        own=own,
        others=others,
    )


def name_vertices(board: Board, polygon: Polygon, fixed: tuple[str, ...]) -> None:
    """The letters of the vertices; points of the frame stand in brackets beside the pole where there is room."""
    gaps = (1.1, 2.0, 3.2, 4.6)
    for place, names in _together(polygon).items():
        at, prefer, told = board.place(place), place or -1 - 1j, ", ".join(names)
        if place == polygon.vertices[polygon.pole] and fixed:
            points = f"{told}, ({', '.join(map(point_name, fixed))})"
            if board.labels.put_where_free(points, at, height=VERTEX, prefer=prefer, gaps=gaps) is not None:
                continue
        board.labels.put(told, [at], height=VERTEX, prefer=prefer, gaps=gaps)


def _together(polygon: Polygon) -> dict[complex, list[str]]:
    """The names of the vertices; those that lie in one place have one label."""
    size = max(map(abs, polygon.vertices.values()))
    names: dict[complex, list[str]] = {}
    for name, tip in polygon.vertices.items():
        place = next((other for other in names if abs(other - tip) <= 2e-3 * size), tip)
        names.setdefault(place, []).append(vertex_name(name))
    return names
