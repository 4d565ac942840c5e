"""A pair on a board while it is drawn: its frame, texts that come last, and the look of all its lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.placedpair import Body, Circle, PlacedPair
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import CURVES, INK

COLOURS = (CURVES[0]["color"], CURVES[1]["color"])  # of wheels 1 and 2
FACES = ("#e4eef6", "#fbeadf")
ACTION = "#009e73"
STYLES: dict[Circle, dict[str, Any]] = {
    "tip": {"linewidth": 0.6, "linestyle": "-"},
    "operating": {"linewidth": 1.0, "linestyle": (0, (12, 2, 2, 2))},
    "reference": {"linewidth": 0.6, "linestyle": (0, (12, 2, 2, 2, 2, 2))},
    "base": {"linewidth": 0.7, "linestyle": (0, (5, 2))},
    "root": {"linewidth": 0.6, "linestyle": "-"},
}
THIN: dict[str, Any] = {"linewidth": 0.5, "color": INK}
CENTRES: dict[str, Any] = {"linewidth": 0.6, "color": INK, "linestyle": (0, (14, 2, 2, 2)), "zorder": 6}
SIZE = 8.5  # of the names of points


class Sketch:
    """One mesh while it is drawn."""

    def __init__(self, board: Board, pair: PlacedPair) -> None:
        self.board, self.pair, self.mm = board, pair, board.mu
        (x0, x1), (y0, y1) = board.axes.get_xlim(), board.axes.get_ylim()
        self.frame = x0, x1, y0, y1
        self.texts: list[tuple[str, Plane, complex, dict[str, Any]]] = []  # texts that come when all is drawn

    def seen(self, z: Plane, inset: float = 0.0) -> np.ndarray:
        """Which points lie within the frame, ``inset`` mm inside it."""
        x0, x1, y0, y1 = self.frame
        b = inset * self.mm
        return np.asarray((z.real > x0 + b) & (z.real < x1 - b) & (z.imag > y0 + b) & (z.imag < y1 - b))

    def text(self, text: str, anchors: Plane | complex, prefer: complex, **style: Any) -> None:
        """Write this later, near one of the anchors."""
        self.texts.append((text, np.atleast_1d(np.asarray(anchors)), prefer, style))

    def names(self) -> None:
        """All texts, those of the points first."""
        for text, anchors, prefer, style in self.texts:
            inside = [complex(z) for z in anchors if self.seen(np.array([z]))[0]]
            if inside:
                self.board.labels.put(text, inside, gaps=(1.3, 2.0, 3.0, 4.4, 6.0), prefer=prefer, **style)


def up_of(body: Body) -> complex:
    """The direction from the centre of a wheel to the pitch point."""
    return -1j if body.number == 2 and body.kind == "external" else 1j


def spread(heights: list[float], step: float, low: float, high: float) -> list[float]:
    """Falling heights moved apart to at least ``step``, between two limits, as little as may be.

    >>> spread([5.0, 4.0, 4.0], 0.5, 0.0, 9.0)
    [5.0, 4.25, 3.75]
    """
    groups: list[list[float]] = []  # neighbours that push each other, without their steps
    for k, height in enumerate(heights):
        groups.append([height + k * step])
        while len(groups) > 1 and _mean(groups[-1]) > _mean(groups[-2]):
            groups[-2:] = [groups[-2] + groups[-1]]
    placed = [_mean(group) for group in groups for _ in group]
    bottom = low + (len(heights) - 1) * step
    return [min(max(y, bottom), high) - k * step for k, y in enumerate(placed)]


def _mean(values: list[float]) -> float:
    return sum(values) / len(values)
