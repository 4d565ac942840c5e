"""The closed force polygon of a free body, to a round scale; the inner reaction of a group is its chord."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.freebody import FreeBody
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import symbol
from tmmcalc.report.drawing.pens import AXIS, FORCES, INK, MIDDLE, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

MARGIN = 7.0  # free border [mm]
HEAD = 3.0
TITLE = 6.0  # height of the line above [mm]
INNER = AXIS._replace(layer="FORCES_INNER", width=0.35)
BEFORE = Pen("OTHER_LIMIT", 0.3, (2.0, 1.0), "#8a8a8a")
NAMED = 2.5  # a shorter vector has no room for its name [mm]


def draw_force_polygon(drawing: Drawing, box: Box, body: FreeBody, other: FreeBody | None) -> None:
    """Draw in a rectangle; ``other`` is the other limit, drawn dashed beneath."""
    title = complex(box.middle.real, box.top)
    if not body.forces:
        drawing.add(Words(title, "no forces", 2.5, 1j))
        return
    vertices = [body.vertices, *([other.vertices] if other else [])]
    board = Board(drawing, box.inset(0, 0, 0, TITLE), np.concatenate(vertices), MARGIN)
    drawing.add(Words(title, f"$μ_F$ = {number(board.mu, 4)} N/mm", 2.5, 1j))
    if other:
        _draw_other(board, other)
    drawn = vectors_of(body)
    for vector in drawn:
        _draw(board, vector)
    board.circle(0j, 0.7, MIDDLE, level=15)
    for vector in drawn:  # the names when all vectors are there, so that each stands at its own
        if abs(vector.value) > NAMED * board.mu:
            _name(board, vector, [other for other in drawn if other is not vector])


class ForceVector(NamedTuple):
    """One arrow of the polygon [N]; ``kind`` is that of the force, None: the chord that closes the forces of a link."""

    tail: complex
    value: complex
    kind: str | None
    name: str

    @property
    def ends(self) -> tuple[complex, complex]:
        """Tail and head."""
        return self.tail, self.tail + self.value


def vectors_of(body: FreeBody) -> list[ForceVector]:
    """The forces of a body in the order of its polygon, and the inner reaction of a group."""
    corners = body.vertices
    found = [
        ForceVector(complex(tail), force.value, force.kind, symbol(force.letter, force.index))
        for tail, force in zip(corners, body.forces, strict=False)
    ]
    if body.inner is not None:
        start = complex(corners[body.closing])
        across = complex(corners[body.parting]) - start
        found.append(ForceVector(start, across, None, symbol(body.inner.letter, body.inner.index)))
    return found


def _draw(board: Board, vector: ForceVector) -> None:
    if vector.kind is not None:
        board.vector(*vector.ends, FORCES[vector.kind], HEAD, level=8)
    elif abs(vector.value) > NAMED * board.mu:
        board.vector(*vector.ends, INNER, HEAD, level=6)


def _name(board: Board, vector: ForceVector, others: list[ForceVector]) -> None:
    anchors = [vector.tail + t * vector.value for t in (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9)]
    board.labels.put(
        vector.name,
        board.paper(anchors),
        colour=INK if vector.kind is None else FORCES[vector.kind].colour,
        prefer=1j * vector.value,
        gaps=(0.6, 0.9, 1.6, 2.6),
        own=board.paper(vector.ends).tolist(),
        others=[board.paper(other.ends).tolist() for other in others],
    )


def _draw_other(board: Board, other: FreeBody) -> None:
    corners = other.vertices
    board.line(corners, BEFORE, weight=0.4, level=4)
    if other.inner is not None:
        board.line(corners[[other.closing, other.parting]], BEFORE, weight=0.3, level=4)
