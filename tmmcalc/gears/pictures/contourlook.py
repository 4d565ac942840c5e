"""The look of a blocking contour: areas, borders, points, and numbers in circles."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmmcalc.gears.meshing.contours import ContourPoint
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK, MARK

RING = 1.9  # radius of the circle around a number [mm]
FONT = 6.5  # of the number
FILL, BORDER, STROKES = "fill", "border", "strokes"
STRICT: dict[str, dict[str, Any]] = {
    FILL: {"facecolor": "#dfeaf4"},
    BORDER: {"color": INK, "linewidth": 2.0},
}
BELT: dict[str, dict[str, Any]] = {
    FILL: {"facecolor": "#faf6ec"},
    BORDER: {"color": INK, "linewidth": 0.9},
    STROKES: {"colors": "#8c8468", "linewidths": 0.5},
}
PALE: dict[str, dict[str, Any]] = {
    FILL: {"facecolor": "#eff3f7"},
    BORDER: {"color": "#7d8891", "linewidth": 0.9},
}
HATCH = 2.0  # distance of the hatching's strokes [mm]
CHOSEN: dict[str, Any] = {
    "color": MARK,
    "marker": "o",
    "markersize": 6.0,
    "markeredgecolor": INK,
    "markeredgewidth": 0.8,
    "linestyle": "",
    "zorder": 14,
}
CORNER: dict[str, Any] = {**CHOSEN, "color": INK, "markersize": 4.2, "zorder": 13}
OTHER: dict[str, Any] = {**CHOSEN, "color": "white", "marker": "D", "markersize": 4.0, "zorder": 12}
JOINT = " = "


def draw_ring(board: Board, at: complex, text: str, color: str) -> None:
    """A number in a circle on its line; texts keep clear of it."""
    board.circle(at, RING, edgecolor=color, linewidth=0.7, zorder=15)
    around = at + RING * board.mu * np.exp(1j * np.linspace(0, 2 * np.pi, 25))
    board.labels.avoid(around, 8.0)  # other numbers sooner cover lines
    look: dict[str, Any] = {"ha": "center", "va": "center_baseline", "zorder": 16, "color": INK}
    board.axes.text(at.real, at.imag, text, fontsize=FONT, **look)


def marker_of(point: ContourPoint) -> dict[str, Any]:
    """How a point is drawn: the chosen one, C, D, E, and the others."""
    if point.name == "chosen":
        return CHOSEN
    return CORNER if len(point.name) == 1 else OTHER


def together(points: Sequence[ContourPoint], near: float) -> list[tuple[ContourPoint, str]]:
    """Points with their names; those that lie on an earlier one only add their name to its."""
    found: list[tuple[ContourPoint, str]] = []
    for point in points:
        for k, (other, name) in enumerate(found):
            if abs(complex(point.x1 - other.x1, point.x2 - other.x2)) < near:
                found[k] = other, f"{name}{JOINT}{point.name}"
                break
        else:
            found.append((point, point.name))
    return found
