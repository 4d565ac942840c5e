"""The closed force polygon of a free body, to a round scale; the inner reaction of a group is its chord."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.linkage.freebody import FreeBody
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import symbol
from tmmcalc.report.drawing.style import FORCES, INK, THIN
from tmmcalc.report.numbers import number

MARGIN = 7.0  # free border [mm]
HEAD = 2.2
NAMED = 2.5  # a shorter vector has no room for its name [mm]


def draw_force_polygon(axes: Axes, body: FreeBody, other: FreeBody | None) -> None:
    """Draw on an axes whose place is settled; ``other`` is the other limit, drawn dashed beneath."""
    axes.set_axis_off()
    if not body.forces:
        axes.set_title("no forces")
        return
    vertices = [body.vertices, *([other.vertices] if other else [])]
    board = Board(axes, np.concatenate(vertices), MARGIN)
    axes.set_title(f"$\\mu_F$ = {number(board.mu, 4)} N/mm", pad=2)
    if other:
        _draw_other(board, other)
    drawn = vectors_of(body)
    for vector in drawn:
        _draw(board, vector)
    board.circle(0j, 0.7, zorder=15)
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
    length = abs(vector.value) / board.mu
    (tail, head), arrow = vector.ends, min(HEAD, 0.45 * length)
    if vector.kind is None:
        if length > NAMED:
            board.line((tail, head), color=INK, linewidth=0.9, linestyle=(0, (6, 2, 1, 2)), zorder=6)
            board.arrowhead(head, vector.value, arrow, facecolor=INK, zorder=7)
        return
    style = FORCES[vector.kind]
    end = head - vector.value / abs(vector.value) * 0.8 * arrow * board.mu
    board.line((tail, end), solid_capstyle="butt", zorder=8, **style)
    board.arrowhead(head, vector.value, arrow, facecolor=style["color"], zorder=9)


def _name(board: Board, vector: ForceVector, others: list[ForceVector]) -> None:
    anchors = [vector.tail + t * vector.value for t in (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9)]
    color = INK if vector.kind is None else FORCES[vector.kind]["color"]
    board.labels.put(
        vector.name,
        anchors,
        size=8,
        color=color,
        prefer=1j * vector.value,
        gaps=(0.6, 0.9, 1.6, 2.6),
        own=vector.ends,
        others=[other.ends for other in others],
    )


def _draw_other(board: Board, other: FreeBody) -> None:
    style = {"color": THIN, "linewidth": 1.0, "linestyle": (0, (3, 1.5)), "zorder": 4}
    corners = other.vertices
    board.line(corners, weight=0.4, **style)
    if other.inner is not None:
        board.line(corners[[other.closing, other.parting]], weight=0.3, **style)
