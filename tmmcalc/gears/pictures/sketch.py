"""A pair on a board while it is drawn: its frame, texts that come last, columns at the sides, the look of all lines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.placedpair import Body, Circle, PlacedPair
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import AXIS, INK, THIN, Pen
from tmmcalc.report.drawing.shapes import Words

COLOURS = ("#0072b2", "#d55e00")  # of wheels 1 and 2
FACES = ("#e4eef6", "#fbeadf")
PROFILE = Pen("PROFILES", 0.5)
WORKING = tuple(Pen(f"WORKING_FLANKS_{k}", 1.0, (), colour) for k, colour in enumerate(COLOURS, 1))
ACTION = Pen("LINE_OF_ACTION", 0.3)
ACTIVE = Pen("ACTIVE_LINE_OF_ACTION", 0.9, (), "#009e73")
CONTACT = Pen("CONTACTS", 0.35, (), "#009e73")
CONTACT_ARC = Pen("ARCS_OF_CONTACT", 0.8)
POINT = Pen("POINTS", 0.13)
LOOKS: dict[Circle, tuple[float, tuple[float, ...]]] = {
    "tip": (0.25, ()),
    "operating": (0.4, AXIS.dashes),
    "reference": (0.25, (5.0, 1.0, 0.8, 1.0, 0.8, 1.0)),
    "base": (0.25, (2.4, 1.0)),
    "root": (0.25, ()),
}
LAYERS = {"operating": "PITCH"}
HEIGHT = 2.8  # of the names of points [mm]
SMALLER = 2.3  # of values at angles and distances
PITCH = 4.6  # of the texts in a column [mm]
COLUMN = 27.0  # width of a column [mm]
LEADER = 5.0  # of it, between the frame and the texts


def circle_pen(circle: Circle, colour: str = INK, number: int = 0) -> Pen:
    """The pen of a circle, of a wheel with this number."""
    wide, dashes = LOOKS[circle]
    name = f"{LAYERS.get(circle, circle.upper())}_CIRCLES"
    return Pen(f"{name}_{number}" if number else name, wide, dashes, colour)


class Sketch:
    """One mesh while it is drawn."""

    def __init__(self, board: Board, pair: PlacedPair) -> None:
        self.board, self.pair, self.mm = board, pair, board.mu
        box = board.box
        self.low, self.high = board.data(complex(box.left, box.bottom)), board.data(complex(box.right, box.top))
        self.texts: list[tuple[str, Plane, complex, dict[str, Any]]] = []  # texts that come when all is drawn
        self.beside: tuple[list[tuple[str, complex, str]], ...] = ([], [])  # texts, places, colours of both columns

    def seen(self, z: Plane, inset: float = 0.0) -> np.ndarray:
        """Which points lie within the frame, ``inset`` mm inside it."""
        b = inset * self.mm
        across = (z.real > self.low.real + b) & (z.real < self.high.real - b)
        return np.asarray(across & (z.imag > self.low.imag + b) & (z.imag < self.high.imag - b))

    def text(self, text: str, anchors: Plane | complex, prefer: complex, **style: Any) -> None:
        """Write this later, near one of the anchors."""
        self.texts.append((text, np.atleast_1d(np.asarray(anchors)), prefer, style))

    def names(self) -> None:
        """All texts, those of the points first, then the columns."""
        for text, anchors, prefer, style in self.texts:
            inside = [complex(z) for z in anchors if self.seen(np.array([z]))[0]]
            if inside:
                self.board.name(text, inside, **{"height": HEIGHT, "prefer": prefer, **style})
        for left, named in zip((True, False), self.beside, strict=True):
            self._column(named, left)

    def _column(self, named: Sequence[tuple[str, complex, str]], left: bool) -> None:
        """Texts one under another beside the ends of their lines, with leaders that do not cross."""
        box, drawing = self.board.box, self.board.drawing
        ends = [(text, self.board.place(at), colour) for text, at, colour in named]
        ends.sort(key=lambda item: (-item[1].imag, item[1].real if left else -item[1].real))
        heights = spread([at.imag for _, at, _ in ends], PITCH, box.bottom + 0.5 * PITCH, box.top - 0.5 * PITCH)
        for (text, end, colour), y in zip(ends, heights, strict=True):
            foot = complex(box.left - LEADER if left else box.right + LEADER, y)
            drawing.line([end, foot], THIN, level=4)
            side = foot + (-0.8 if left else 0.8)
            size = 2.3 * min(1.0, (COLUMN - LEADER - 0.8) / width(text, 2.3))
            drawing.add(Words(side, text, size, 1 if left else -1, colour=colour), level=20)


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
