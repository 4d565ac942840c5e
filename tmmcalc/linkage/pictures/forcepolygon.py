"""The closed force polygon of a free body, to a round scale; the inner reaction of a group is its chord."""

from __future__ import annotations

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
    corners = body.vertices
    for tail, force in zip(corners, body.forces, strict=False):
        _arrow(board, complex(tail), force.value, force.kind, symbol(force.letter, force.index))
    if body.inner is not None:
        start = complex(corners[body.closing])
        _chord(board, start, complex(corners[body.parting]) - start, symbol(body.inner.letter, body.inner.index))
    board.circle(0j, 0.7, zorder=15)


def _arrow(board: Board, tail: complex, value: complex, kind: str, name: str) -> None:
    style, length = FORCES[kind], abs(value) / board.mu
    arrow = min(HEAD, 0.45 * length)
    head = tail + value
    end = head - value / abs(value) * 0.8 * arrow * board.mu
    board.line((tail, end), solid_capstyle="butt", zorder=8, **style)
    board.arrowhead(head, value, arrow, facecolor=style["color"], zorder=9)
    if length > NAMED:
        _name(board, tail, value, name, style["color"])


def _chord(board: Board, tail: complex, value: complex, name: str) -> None:
    """The inner reaction: it closes the forces of one link."""
    length = abs(value) / board.mu
    if length <= NAMED:
        return
    board.line((tail, tail + value), color=INK, linewidth=0.9, linestyle=(0, (6, 2, 1, 2)), zorder=6)
    board.arrowhead(tail + value, value, min(HEAD, 0.45 * length), facecolor=INK, zorder=7)
    _name(board, tail, value, name, INK)


def _name(board: Board, tail: complex, value: complex, name: str, color: str) -> None:
    anchors = [tail + t * value for t in (0.5, 0.35, 0.65, 0.2, 0.8)]
    board.labels.put(name, anchors, size=8, color=color, prefer=1j * value, gaps=(0.9, 1.6, 2.6))


def _draw_other(board: Board, other: FreeBody) -> None:
    style = {"color": THIN, "linewidth": 1.0, "linestyle": (0, (3, 1.5)), "zorder": 4}
    corners = other.vertices
    board.line(corners, weight=0.4, **style)
    if other.inner is not None:
        board.line(corners[[other.closing, other.parting]], weight=0.3, **style)
