"""What a drawing is made of: shapes with a meaning, in millimetres of paper from its lower left corner.

Points are complex numbers x + i y, or arrays of them. Angles of arcs are in rad, counter-clockwise from x.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import DIMENSION, HATCH, INK, TEXT, Pen
from tmmcalc.report.language import spoken

ARROW = 2.5  # length of an arrowhead [mm]
BARB = 0.2  # half of its width to its length
SPECK = 0.05  # lines of a hatching that are shorter are left out [mm]
BEYOND = 1.5  # how far an extension line goes over its dimension line [mm]


class Stroke(NamedTuple):
    """A polyline through points (n,)."""

    points: Plane
    pen: Pen
    closed: bool = False


class Arc(NamedTuple):
    """A part of a circle, from ``start`` counter-clockwise to ``end``; a turn or more is the whole circle."""

    centre: complex
    radius: float
    pen: Pen
    start: float = 0.0
    end: float = 2 * math.pi
    fill: str = ""  # colour inside a whole circle

    @property
    def whole(self) -> bool:
        """Whether it closes."""
        return self.end - self.start >= 2 * math.pi * (1 - 1e-12)

    @property
    def points(self) -> Plane:
        """Its ends, of a circle its extreme points."""
        angles = np.arange(4) * math.pi / 2 if self.whole else np.array([self.start, self.end])
        return np.asarray(self.centre + self.radius * np.exp(1j * angles))


class Area(NamedTuple):
    """A filled polygon (n,), with or without an outline."""

    points: Plane
    fill: str
    pen: Pen | None = None


class Hatching(NamedTuple):
    """Parallel lines inside closed polygons, ``pitch`` mm apart; a polygon inside another one is left free."""

    loops: tuple[Plane, ...]
    angle: float = math.pi / 4
    pitch: float = 2.0
    pen: Pen = HATCH

    @property
    def points(self) -> Plane:
        """Corners of all polygons."""
        return np.concatenate(self.loops)


class Words(NamedTuple):
    """A text of one or several lines, see `lettering`; ``height`` is that of its capitals [mm]."""

    at: complex
    text: str
    height: float = 3.5
    align: complex = 0j  # what of the text stands at the place: -1 left, 1 right, -i below, i above, 0 the middle
    turn: float = 0.0  # [rad]
    colour: str = INK
    clear: bool = False  # whether a white rim keeps it apart from what lies beneath
    pen: Pen = TEXT


class Dimension(NamedTuple):
    """The distance of two points, on a line through ``line``; along ``angle``, None: along themselves."""

    first: complex
    second: complex
    line: complex
    text: str
    height: float = 3.5
    angle: float | None = None
    pen: Pen = DIMENSION

    def parts(self) -> list[Shape]:
        """The lines, arrows and words that it is drawn with."""
        e = np.exp(1j * self.angle) if self.angle is not None else _unit(self.second - self.first)
        normal = 1j * e
        feet = [point + ((self.line - point) * np.conj(normal)).real * normal for point in (self.first, self.second)]
        found: list[Shape] = []
        for point, foot in zip((self.first, self.second), feet, strict=True):
            if abs(foot - point) > 0.5:
                over = _unit(foot - point)
                found.append(Stroke(np.array([point + 0.5 * over, foot + BEYOND * over]), self.pen))
        start, end = feet
        along = _unit(end - start)
        inside = abs(end - start) > 3 * ARROW
        reach, wide = 0.0 if inside else 2 * ARROW, width(self.text, self.height)
        beyond = 0.0 if wide < abs(end - start) else max(reach, 1.0) + wide + 0.5  # words that have no room between
        found.append(Stroke(np.array([start - reach * along, end + max(reach, beyond) * along]), self.pen))
        sense = 1 if inside else -1
        found += [arrowhead(start, -sense * along, self.pen), arrowhead(end, sense * along, self.pen)]
        turn = math.atan2(along.imag, along.real)
        if not -math.pi / 2 < turn <= math.pi / 2 + 1e-9:
            turn -= math.copysign(math.pi, turn)
        above = 1j * np.exp(1j * turn)
        middle = end + (beyond - 0.5 - wide / 2) * along if beyond else (start + end) / 2
        found.append(Words(middle + 0.9 * above, self.text, self.height, -1j, turn, pen=self.pen))
        return found

    @property
    def points(self) -> Plane:
        """The measured points and the place of the line."""
        return np.array([self.first, self.second, self.line])


Shape = Stroke | Arc | Area | Hatching | Words | Dimension


class Drawing:
    """A sheet of paper of ``width`` by ``height`` mm with its shapes, in the order in which they are drawn."""

    def __init__(self, width: float, height: float, title: str = "") -> None:
        self.width, self.height, self.title, self.language = width, height, title, spoken()
        self.letters = 1.0  # how many times larger names are than usual
        self.fields: list[Any] = []  # the boards and diagrams on it
        self._levels: list[tuple[float, Shape]] = []

    @property
    def shapes(self) -> list[Shape]:
        """All shapes, those of a higher level over those of a lower one, else in the order in which they came."""
        return [shape for _, shape in sorted(self._levels, key=lambda each: each[0])]

    def add(self, *shapes: Shape, level: float = 0.0) -> None:
        """Draw these shapes over what is there, on a level."""
        self._levels += [(level, shape) for shape in shapes]

    def mark(self) -> tuple[int, int]:
        """How much is drawn, for `undo`."""
        return len(self._levels), len(self.fields)

    def since(self, mark: tuple[int, int]) -> list[Shape]:
        """What was drawn since that mark."""
        return [shape for _, shape in self._levels[mark[0] :]]

    def undo(self, mark: tuple[int, int]) -> None:
        """Take away what was drawn since that mark."""
        del self._levels[mark[0] :], self.fields[mark[1] :]

    @contextmanager
    def lettered(self, factor: float) -> Iterator[None]:
        """Names within are so many times larger, as on a large sheet, which is read from farther away."""
        before, self.letters = self.letters, factor
        try:
            yield
        finally:
            self.letters = before

    def line(self, points: Iterable[complex], pen: Pen, *, closed: bool = False, level: float = 0.0) -> None:
        """A polyline."""
        self.add(Stroke(np.asarray(list(points), complex), pen, closed), level=level)

    def vector(self, tail: complex, tip: complex, pen: Pen, head: float = ARROW, level: float = 0.0) -> None:
        """An arrow from tail to tip; a short one has a head of its own length."""
        size = min(head, 0.6 * abs(tip - tail))
        if size > 0:
            e = _unit(tip - tail)
            self.add(Stroke(np.array([tail, tip - 0.8 * size * e]), pen), arrowhead(tip, e, pen, size), level=level)


def arrowhead(tip: complex, direction: complex, pen: Pen, length: float = ARROW) -> Area:
    """A filled arrowhead at a tip; ``direction`` is a unit vector."""
    back = tip - length * direction
    side = 1j * direction * BARB * length
    return Area(np.array([tip, back + side, back - side]), pen.colour, pen._replace(width=0.0))


def _unit(vector: complex) -> complex:
    return vector / abs(vector) if vector else 1 + 0j


def hatch_lines(hatching: Hatching) -> list[Plane]:
    """The lines of a hatching, each from end to end (2,), by the even-odd rule."""
    turned = [loop * np.exp(-1j * hatching.angle) for loop in hatching.loops]
    low = min(float(loop.imag.min()) for loop in turned)
    high = max(float(loop.imag.max()) for loop in turned)
    # lines at whole multiples of the pitch, so that neighbouring areas of one body go on
    first, last = math.ceil(low / hatching.pitch), math.floor(high / hatching.pitch)
    found: list[Plane] = []
    for k in range(first, last + 1):
        y = k * hatching.pitch
        cuts: list[float] = []
        for loop in turned:
            a, b = loop, np.roll(loop, -1)
            across = (a.imag <= y) != (b.imag <= y)
            a, b = a[across], b[across]
            cuts += (a.real + (y - a.imag) / (b.imag - a.imag) * (b.real - a.real)).tolist()
        cuts.sort()
        for start, end in zip(cuts[::2], cuts[1::2], strict=False):
            if end - start < SPECK:  # where polygons have a common border
                continue
            found.append(np.array([start + 1j * y, end + 1j * y]) * np.exp(1j * hatching.angle))
    return found
