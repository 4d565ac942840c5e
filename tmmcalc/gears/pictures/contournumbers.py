"""The numbers of the lines of a blocking contour: each in a circle on its line, where least else is drawn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.contourlines import Stroke
from tmmcalc.gears.pictures.contourlook import RING, ring
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.labels import AROUND
from tmmcalc.report.drawing.pens import Pen

CANDIDATES = 45  # places that a number tries along its line
POINTS = 400  # of a line, evenly apart
CLEAR = 0.5  # about a circle [mm]
NAMED = 20.0  # what a mm of it on a name costs
EDGE = 4.0  # from the centre of a circle to the border [mm]
SHORT = 12.0  # a line that is not longer has its number beside it [mm]
BESIDE = (4.5, 6.0, 8.0)  # how far [mm]
ONE = 3 * RING  # paths that keep nearer are one [mm]


def seen(board: Board, path: Plane, edge: float = 0.0) -> Plane:
    """Places on paper along a path of data, evenly apart, in the picture and ``edge`` mm off its border."""
    along = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(path)))))
    at = np.linspace(0.0, along[-1], POINTS)
    z = board.paper(np.interp(at, along, path.real) + 1j * np.interp(at, along, path.imag))
    box = board.box.inset(edge, edge, edge, edge)
    across = (z.real > box.left) & (z.real < box.right)
    return np.asarray(z[across & (z.imag > box.bottom) & (z.imag < box.top)])


def number_stroke(board: Board, stroke: Stroke) -> None:
    """The number of a line, on each of its long parts; of a short line beside it."""
    parts = [z for path in stroke.paths for z in [seen(board, path, EDGE)] if z.size]
    parts = list(_apart(parts, ONE))
    long = [z for z in parts if np.abs(np.diff(z)).sum() > SHORT]
    colour = stroke.pens[0].colour
    for z in long or parts[:1]:
        for text in filter(None, stroke.number.split(", ")):
            if long:
                at = _roomiest(board, z[:: max(1, z.size // CANDIDATES)])
            else:
                middle = complex(z[z.size // 2])
                at = _roomiest(board, np.concatenate([middle + gap * AROUND for gap in BESIDE]))
                board.drawing.line([middle, at], Pen("NUMBERS", 0.18, (), colour), level=6)
                board.labels.avoid([middle, at], 0.8)
            board.drawing.add(*ring(at, text, colour), level=15)
            around = at + RING * np.exp(1j * np.linspace(0, 2 * np.pi, 25))
            board.labels.avoid(around, 8.0)  # other numbers sooner cover lines


def _roomiest(board: Board, places: Plane) -> complex:
    """The place about which least is drawn, and no name."""
    labels, round_it = board.labels, RING * np.array([-1, 1])
    cost = [
        labels.crowded([at, at], RING + CLEAR) + sum(NAMED * labels.struck(at + e * round_it) for e in (1, 1j))
        for at in places.tolist()
    ]
    return complex(places[int(np.argmin(cost))])


def _apart(paths: Iterable[Plane], near: float) -> Iterator[Plane]:
    """The longest paths first, without those that lie on another one."""
    kept: list[Plane] = []
    for path in sorted(paths, key=lambda z: -float(np.abs(np.diff(z)).sum())):
        if not any(np.max(np.min(np.abs(path[:, None] - other), axis=1)) < near for other in kept):
            kept.append(path)
            yield path
