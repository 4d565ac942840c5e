"""How the admissible zone, its limits and the axis of the cam are drawn."""

from __future__ import annotations

from typing import Any

from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK, MARK, PATH, THIN

ZONE: dict[str, Any] = {"facecolor": "#e3f1ea", "edgecolor": "#7fbf9f", "hatch": "////", "linewidth": 0.0, "zorder": 1}
LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 1.2, "linestyle": (0, (6, 2)), "zorder": 6}
PASSING: dict[str, Any] = {"color": "#7a5195", "linewidth": 1.2, "linestyle": (0, (8, 2, 2, 2)), "zorder": 6}
OTHER: dict[str, Any] = {"color": THIN, "linewidth": 0.5, "linestyle": "-", "zorder": 2}
BASE: dict[str, Any] = {"color": PATH, "linewidth": 1.0, "linestyle": (0, (6, 2, 1, 2)), "zorder": 5}
DIMENSION: dict[str, Any] = {"color": INK, "linewidth": 0.6, "zorder": 7}


def axis_of_cam(board: Board, at: complex, name: str = "$O$", **style: Any) -> None:
    """A double circle with its name."""
    board.circle(at, 1.5, zorder=15, **style)
    board.circle(at, 0.35, zorder=16, **{"facecolor": INK, **style})
    board.labels.put(name, [at], size=9.5, prefer=-1 - 1j)


def dimension(board: Board, a: complex, b: complex, text: str) -> None:
    """A dimension line from a to b with heads at both ends and its text beside the middle."""
    if abs(b - a) < 1.5 * board.mu:
        return
    board.line([a, b], **DIMENSION)
    length = min(2.2, 0.3 * abs(b - a) / board.mu)
    board.arrowhead(a, a - b, length)
    board.arrowhead(b, b - a, length)
    board.labels.put(text, [(a + b) / 2], size=8.5, prefer=1j * (b - a))
