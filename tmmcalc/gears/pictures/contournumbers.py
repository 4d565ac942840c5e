"""The numbers of the lines of a blocking contour: each in a circle on its line, where least else is drawn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.contourlines import Stroke
from tmmcalc.gears.pictures.contourlook import RING, draw_ring
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import AROUND

CANDIDATES = 45  # places that a number tries along its line
POINTS = 400  # of a line, evenly apart
CLEAR = 0.5  # about a circle [mm]
EDGE = 4.0  # from the centre of a circle to the border [mm]
SHORT = 12.0  # a line that is not longer has its number beside it [mm]
BESIDE = (4.5, 6.0, 8.0)  # how far [mm]
ONE = 3 * RING  # paths that keep nearer are one [mm]


def corners(board: Board) -> tuple[complex, complex]:
    """The lower left and the upper right corner of the picture."""
    (x0, x1), (y0, y1) = board.axes.get_xlim(), board.axes.get_ylim()
    return complex(x0, y0), complex(x1, y1)


def seen(board: Board, path: Plane, edge: float = 0.0) -> Plane:
    """Points of a path, evenly apart, that lie in the picture and ``edge`` mm off its border."""
    along = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(path)))))
    at = np.linspace(0.0, along[-1], POINTS)
    z = np.interp(at, along, path.real) + 1j * np.interp(at, along, path.imag)
    low, high = corners(board)
    away = edge * board.mu
    across = (z.real > low.real + away) & (z.real < high.real - away)
    return np.asarray(z[across & (z.imag > low.imag + away) & (z.imag < high.imag - away)])


def number_stroke(board: Board, stroke: Stroke) -> None:
    """The number of a line, on each of its long parts; of a short line beside it."""
    parts = [z for path in stroke.paths for z in [seen(board, path, EDGE)] if z.size]
    parts = list(_apart(parts, ONE * board.mu))
    long = [z for z in parts if np.abs(np.diff(z)).sum() > SHORT * board.mu]
    color = stroke.look["color"]
    for z in long or parts[:1]:
        for text in filter(None, stroke.number.split(", ")):
            if long:
                at = _roomiest(board, z[:: max(1, z.size // CANDIDATES)])
            else:
                middle = complex(z[z.size // 2])
                at = _roomiest(board, np.concatenate([middle + gap * board.mu * AROUND for gap in BESIDE]))
                board.line([middle, at], weight=0.8, linewidth=0.5, color=color, zorder=6)
            draw_ring(board, at, text, color)


def _roomiest(board: Board, places: Plane) -> complex:
    """The place about which least is drawn."""
    cost = [board.labels.crowded([at, at], RING + CLEAR) for at in places.tolist()]
    return complex(places[int(np.argmin(cost))])


def _apart(paths: Iterable[Plane], near: float) -> Iterator[Plane]:
    """The longest paths first, without those that lie on another one."""
    kept: list[Plane] = []
    for path in sorted(paths, key=lambda z: -float(np.abs(np.diff(z)).sum())):
        if not any(np.max(np.min(np.abs(path[:, None] - other), axis=1)) < near for other in kept):
            kept.append(path)
            yield path
