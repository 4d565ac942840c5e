"""A diagram on paper: a frame with round ticks, a grid, a zero line, curves, names of the curves, marked extremes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.core.plane import Plane, Real
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Field
from tmmcalc.report.drawing.lettering import extent, minus, plain, width
from tmmcalc.report.drawing.pens import CURVES, GRID, MIDDLE, THIN, WHITE, Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Drawing, Words
from tmmcalc.report.language import tr_number, tr_unit
from tmmcalc.report.numbers import number

HEIGHT = 2.5  # of the numbers along the axes [mm]
STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
DEGREES = (5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 360.0)
NAMED = 3.5  # from a frame over the numbers of its ordinate to the name of it, but for their width [mm]
TOUCHING = 1.5  # numbers of an abscissa are not nearer [mm]
ROOM = 8.0  # least distance of ticks along y, with numbers on each [mm]
SAMPLE = 9.0  # length of a line in the key [mm]
ROW = 4.2  # height of a row of it
AIR = 4.0  # behind a name in it, or between it and a title
DOT = 0.42  # radius of a marked position [mm]
NOISE = 1e-12  # of the largest value
RULED = 0.5  # weight by which names keep clear of straight lines across and along
FEWEST, CLOSEST = 3, 1.5  # ticks of an ordinate though they stand nearer than that, so many heights of its numbers
FEW = 3  # a logarithmic axis that spans fewer decades has ticks at 1, 2 and 5 of each


SIGNS = {  # corners of the signs of points, about their middle
    "o": np.exp(2j * np.pi * np.arange(16) / 16),
    "s": 0.9 * np.array([-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j]),
    "D": 1.15 * np.array([-1j, 1, 1j, -1]),
    "^": 1.15 * np.array([-1 - 0.7j, 1 - 0.7j, 1.1j]),
    "v": 1.15 * np.array([-1 + 0.7j, -1.1j, 1 + 0.7j]),
    "<": 1.15 * np.array([0.7 + 1j, -1.1, 0.7 - 1j]),
    ">": 1.15 * np.array([-0.7 - 1j, 1.1, -0.7 + 1j]),
    "P": 1.1 * np.array([a * w for a in (1, 1j, -1, -1j) for w in (1 - 0.35j, 1 + 0.35j, 0.35 + 0.35j)]),
    "X": 1.1
    * np.exp(0.25j * np.pi)
    * np.array([a * w for a in (1, 1j, -1, -1j) for w in (1 - 0.3j, 1 + 0.3j, 0.3 + 0.3j)]),
    "*": np.array([r * np.exp(1j * np.pi * (0.5 + k / 5)) for k, r in enumerate([1.4, 0.55] * 5)]),
}


class Curve(NamedTuple):
    """A curve by its values over the abscissa."""

    name: str
    values: Real
    pen: Pen = CURVES[0]
    marks: tuple[complex, ...] = ()  # extremes that are named, x + i y


class Axis(NamedTuple):
    """What stands along an axis: its name with the unit, and its ends; from a higher to a lower one it runs back."""

    name: str
    low: float
    high: float
    degrees: bool = False
    log: bool = False  # whether equal ratios have equal lengths
    whole: bool = False  # whether it counts: whole numbers alone

    def along(self, values: Real) -> Real:
        """What has equal lengths along it."""
        return np.asarray(np.log10(values)) if self.log else values

    def has(self, value: float) -> bool:
        """Whether a value lies on it."""
        return min(self.low, self.high) <= value <= max(self.low, self.high)


class Diagram(Field):
    """Curves over one abscissa in the frame ``box``; names of the axes and numbers stand outside of it."""

    def __init__(
        self, drawing: Drawing, box: Box, x: Axis, y: Axis, *, numbered: bool = True, lettered: bool = True
    ) -> None:
        """Frame and grid; with numbers and name the abscissa where ``numbered``, the ordinate where ``lettered``."""
        y = y if y.high > y.low else y._replace(low=y.low - 1.0, high=y.high + 1.0)
        (left, right), (low, high) = (axis.along(np.array([axis.low, axis.high])).tolist() for axis in (x, y))
        factors = box.width / (right - left), box.height / (high - low)
        super().__init__(drawing, box, complex(left, low), factors)
        self.x, self.y = x, y
        self._grid(numbered, lettered)

    def paper(self, z: Plane | Sequence[complex]) -> Plane:
        """Places on paper of data."""
        data = np.asarray(z, complex)
        return super().paper(self.x.along(data.real) + 1j * self.y.along(data.imag))

    def data(self, at: complex) -> complex:
        """The datum at a place on paper."""
        found = super().data(at)
        x, y = (10.0**v if axis.log else v for axis, v in ((self.x, found.real), (self.y, found.imag)))
        return complex(x, y)

    def _grid(self, numbered: bool, lettered: bool) -> None:
        box, draw, larger = self.box, self.drawing, self.drawing.letters
        along = across(self.x, box.width, larger)
        up = upward(self.y, box.height, larger)
        height = HEIGHT * larger
        for value in along:
            at = self.place(complex(value, self.y.low)).real
            draw.line([complex(at, box.bottom), complex(at, box.top)], GRID, level=-2)
            draw.line([complex(at, box.bottom), complex(at, box.bottom - 0.9)], THIN, level=-1)
            if numbered:
                draw.add(Words(complex(at, box.bottom - 1.5), written(value, along), height, 1j))
        for value in up if lettered else ():
            at = self.place(complex(self.x.low, value)).imag
            draw.line([complex(box.left, at), complex(box.right, at)], GRID, level=-2)
            draw.line([complex(box.left, at), complex(box.left - 0.9, at)], THIN, level=-1)
            draw.add(Words(complex(box.left - 1.5, at), written(value, up), height, 1))
        if not self.y.log and self.y.low < 0 < self.y.high:
            at = self.place(complex(self.x.low, 0.0)).imag
            zero = [complex(box.left, at), complex(box.right, at)]
            draw.line(zero, MIDDLE, level=-1)
            self.labels.avoid(zero, RULED)
        corners = [complex(box.left, box.bottom), complex(box.right, box.bottom)]
        corners += [complex(box.right, box.top), complex(box.left, box.top)]
        draw.line(corners, THIN, closed=True, level=-1)
        if lettered:
            side = complex(box.left - NAMED - _widest(up, height), box.middle.imag)
            size = 1.2 * height * min(1.0, box.height / (width(self.y.name, 1.2 * height) or 1.0))
            draw.add(Words(side, self.y.name, size, -1j, math.pi / 2))
        if numbered:
            below = complex(box.middle.real, box.bottom - 3.0 - 1.6 * height)
            draw.add(Words(below, self.x.name, 1.2 * height, 1j))

    def draw(self, x: Real, curves: Sequence[Curve], *, key: bool = True, digits: int = 4) -> None:
        """The curves, their names in a row above the frame, and their marked places."""
        for curve in curves:
            self.curve(x + 1j * curve.values, curve.pen)
        if key:
            self.key([(curve.name, curve.pen) for curve in curves])
        done: list[complex] = []
        for curve in curves:
            peak = float(np.max(np.abs(curve.values), initial=0.0))
            for mark in curve.marks:
                at = self.place(mark)
                if all(abs(at - other) > 0.5 for other in done):
                    done.append(at)
                    self.mark(mark, number(0.0 if abs(mark.imag) < NOISE * peak else mark.imag, digits), curve.pen)

    def marker(self, at: complex, kind: str, pen: Pen, size: float = 1.2, *, filled: bool = True) -> None:
        """A sign of a point, one of `SIGNS`; ``size`` is its width [mm]."""
        corners = sign(self.drawing, self.place(at), kind, pen, size, filled=filled)
        self.labels.avoid([*corners, corners[0]], 1.0)

    def mark(self, at: complex, text: str, pen: Pen, height: float = HEIGHT) -> None:
        """A diamond with its value, where it covers least."""
        here = self.place(at)
        size = 0.65
        corners = np.array([here + size * 1j, here - size, here - size * 1j, here + size])
        self.drawing.add(Area(corners, WHITE, pen._replace(width=0.25, dashes=())), level=6)
        self.labels.avoid([*corners, corners[0]], 2.0)
        gaps = (0.9, 1.7, 2.8, 4.0, 5.5)
        prefer = 1j if at.imag >= 0 else -1j
        self.labels.put(minus(text), [here], height=height, prefer=prefer, gaps=gaps, colour=pen.colour)

    def dots(self, x: Real, y: Real, pen: Pen, radius: float = DOT) -> None:
        """Values at positions."""
        fine = pen._replace(width=0.13, dashes=())
        for at in self.paper(x + 1j * y).tolist():
            self.drawing.add(Arc(at, radius, fine, fill=pen.colour), level=5)

    def key(self, names: Sequence[tuple[str, Pen]], lift: float = 0.0) -> None:
        """Names of curves with a piece of their line, in rows above the frame, from the left."""
        key_above(self.drawing, self.box, names, lift)

    def band(self, low: float, high: float, colour: str) -> None:
        """A strip of colour over a part of the abscissa."""
        ends = sorted((self.x.low, self.x.high))
        a, b = (self.place(complex(min(max(v, ends[0]), ends[1]), self.y.low)).real for v in (low, high))
        box = self.box
        corners = [complex(a, box.bottom), complex(b, box.bottom), complex(b, box.top), complex(a, box.top)]
        self.drawing.add(Area(np.array(corners), colour), level=-3)

    def level(self, y: float, pen: Pen, name: str = "") -> None:
        """A line along at a height, with its name above at the right; names keep clear of it."""
        if self.y.has(y):
            at = self.place(complex(self.x.low, y)).imag
            ends = [complex(self.box.left, at), complex(self.box.right, at)]
            self.drawing.line(ends, pen, level=1)
            self.labels.avoid(ends, RULED)
            if name:
                height = 0.85 * HEIGHT * self.drawing.letters
                self.drawing.add(Words(complex(self.box.right - 1.0, at + 0.7), name, height, 1 - 1j), level=5)

    def name_level(self, y: float, name: str, colour: str) -> None:
        """The name of a height beside its line, where it covers least, on the right if it can."""
        if name and self.y.has(y):
            across = self.box.left + np.array([0.97, 0.85, 0.7, 0.5, 0.3, 0.1]) * self.box.width
            at = self.place(complex(self.x.low, y)).imag
            self.labels.put(name, across + 1j * at, prefer=-0.1 + 1j, gaps=(0.8, 1.5, 2.4), colour=colour)

    def point(self, at: complex, pen: Pen, radius: float = 0.7, fill: str = WHITE) -> complex:
        """An open circle at a datum; its place on paper."""
        here = self.place(at)
        self.drawing.add(Arc(here, radius, pen._replace(width=0.25, dashes=()), fill=fill), level=7)
        self.labels.avoid(here + radius * np.exp(1j * np.linspace(0, 2 * np.pi, 9)), 2.0)
        return here

    def vertical(self, x: float, pen: Pen) -> None:
        """A line across at a place of the abscissa; names keep clear of it."""
        if self.x.has(x):
            at = self.place(complex(x, self.y.low)).real
            ends = [complex(at, self.box.bottom), complex(at, self.box.top)]
            self.drawing.line(ends, pen, level=1)
            self.labels.avoid(ends, RULED)


def named(header: str) -> str:
    """What stands along the axis of a column: the name of its header as it is, and the unit.

    >>> named("kinematics.vS_D[m/s]"), named("train.criteria[0]")
    ('kinematics.vS_D, m/s', 'train.criteria[0]')
    """
    name, unit = key_and_unit(header)
    return f"{plain(name)}, {tr_unit(unit)}" if unit else plain(name)


def sign(drawing: Drawing, at: complex, kind: str, pen: Pen, size: float, *, filled: bool = True) -> Plane:
    """A sign at a place on paper; its corners."""
    corners = at + size / 2 * SIGNS[kind]
    fine = pen._replace(width=0.2, dashes=())
    fill = pen.colour if filled else WHITE
    drawing.add(Arc(at, size / 2, fine, fill=fill) if kind == "o" else Area(corners, fill, fine), level=6)
    return np.asarray(corners)


def key_above(drawing: Drawing, box: Box, names: Sequence[tuple[str, Pen]], lift: float = 0.0) -> None:
    """Names of curves with a piece of their line, in rows above a rectangle, from the left."""
    larger = drawing.letters
    rows = key_rows(names, box.width, larger)
    for k, row in enumerate(rows):
        at = complex(box.left, box.top + larger * (ROW / 2 + (len(rows) - 1 - k) * ROW) + 0.1 + lift)
        for name, pen in row:
            drawing.line([at, at + SAMPLE], pen)
            drawing.add(Words(at + SAMPLE + 1.2, name, HEIGHT * larger, -1))
            at += sample(name, larger)


def key_rows(names: Sequence[tuple[str, Pen]], wide: float, larger: float = 1.0) -> list[list[tuple[str, Pen]]]:
    """The names of curves, so many times ``larger`` than usual, in rows that are no wider than this [mm]."""
    rows: list[list[tuple[str, Pen]]] = []
    at = math.inf
    for name, pen in names:
        if at + sample(name, larger) - AIR > wide:
            rows.append([])
            at = 0.0
        rows[-1].append((name, pen))
        at += sample(name, larger)
    return rows


def sample(name: str, larger: float) -> float:
    """Room of a name with its piece of line, and air."""
    return SAMPLE + 1.2 + width(name, HEIGHT * larger) + AIR


def beside(y: Axis, high: float, larger: float = 1.0) -> float:
    """Room at the left of a frame ``high`` mm high that numbers and name of its ordinate take [mm]."""
    height = HEIGHT * larger
    return NAMED + _widest(upward(y, high, larger), height) + sum(extent(y.name, 1.2 * height))


def _widest(values: Sequence[float], height: float) -> float:
    """The width of the longest of the numbers of an axis [mm]."""
    return max((width(written(value, values), height) for value in values), default=0.0)


def upward(axis: Axis, high: float, larger: float = 1.0) -> list[float]:
    """The ticks of an ordinate in a frame ``high`` mm high."""
    return ticks(axis, max(2, int(high / ROOM / larger)), FEWEST, int(high / (CLOSEST * HEIGHT) / larger) + 1)


def across(axis: Axis, wide: float, larger: float = 1.0) -> list[float]:
    """The ticks of an abscissa in a frame ``wide`` mm wide: so few that their numbers do not touch."""
    most = max(2, int(wide / 12 / larger))
    span = abs(float(np.subtract(*axis.along(np.array([axis.low, axis.high])))))
    while len(found := ticks(axis, most)) > 2 and most > 2:
        apart = wide / span * float(np.diff(axis.along(np.array(found))).min())
        if _widest(found, HEIGHT * larger) + TOUCHING <= apart:
            break
        most -= 1
    return found


def ticks(axis: Axis, most: int, fewest: int = 2, utmost: int = 6) -> list[float]:
    """Round values within an axis, at most so many and one.

    Where these are fewer than ``fewest`` there are more of them, up to ``utmost``; there are two if it can be.

    >>> ticks(Axis("", 0.0, 1.0), 5)
    [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]
    >>> ticks(Axis("", 0.0, 360.0, True), 8)
    [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0]
    >>> ticks(Axis("", 0.3, 12.0, log=True), 8), ticks(Axis("", 3.0, 5.4, whole=True), 8)
    ([0.5, 1.0, 2.0, 5.0, 10.0], [3.0, 4.0, 5.0])
    >>> ticks(Axis("", 0.6, 1.7), 2), ticks(Axis("", 0.6, 1.7), 2, 3), ticks(Axis("", 0.25, 0.4, log=True), 3)
    ([1.0, 1.5], [0.75, 1.0, 1.25, 1.5], [0.25, 0.3, 0.35, 0.4])
    """
    low, high = sorted((axis.low, axis.high))
    if axis.log:
        found = _powers(low, high, most)
        return found if len(found) >= fewest else ticks(axis._replace(log=False), most, fewest, utmost)
    least = max((high - low) / most, 1.0 if axis.whole else 0.0)
    power = 10.0 ** math.floor(math.log10(least)) if least > 0 else 1.0
    steps = [step * power for step in (*(step / 10.0 for step in STEPS[:-1]), *STEPS)]
    if axis.degrees and 2.5 < least <= DEGREES[-1]:
        steps = list(DEGREES)
    if axis.whole:
        steps = [step for step in steps if step == round(step)]
    chosen = next((k for k, step in enumerate(steps) if step >= least * (1 - 1e-9)), len(steps) - 1)
    found = _multiples(steps[chosen], low, high)
    for step in reversed(steps[:chosen]):
        more = _multiples(step, low, high)
        if len(found) >= fewest or (len(found) > 1 and len(more) > utmost):
            break
        found = more
    return found


def _multiples(step: float, low: float, high: float) -> list[float]:
    """The multiples of a step from one end to the other."""
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [round(k * step, 12 - math.floor(math.log10(step))) for k in range(first, last + 1)]


def _powers(low: float, high: float, most: int) -> list[float]:
    """Powers of ten between two ends, where these are near each other 1, 2 and 5 times them."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    if last - first < FEW:
        every = [m * 10.0**k for k in range(first - 1, last + 1) for m in (1, 2, 5)]
        return [float(f"{value:.1g}") for value in every if low <= value * (1 + 1e-9) and value <= high * (1 + 1e-9)]
    return [10.0**k for k in range(first, last + 1, max(1, math.ceil((last - first) / most)))]


def one_scale(box: Box, x: Axis, y: Axis) -> tuple[Axis, Axis]:
    """The axes of a diagram in which equal lengths are equal data: one of them longer, to both sides."""
    scale = max((x.high - x.low) / box.width, (y.high - y.low) / box.height)
    more = [(scale * size - (axis.high - axis.low)) / 2 for axis, size in ((x, box.width), (y, box.height))]
    first, second = (axis._replace(low=axis.low - d, high=axis.high + d) for axis, d in zip((x, y), more, strict=True))
    return first, second


def written(value: float, others: Sequence[float]) -> str:
    """A number of an axis, with the decimals that all of its numbers need."""
    if others and min(others) > 0 and max(others) >= 1e3 * min(others):  # of a logarithmic axis
        return tr_number(f"{value:g}") if 1e-3 <= value <= 1e4 else f"$10^{{{minus(str(round(math.log10(value))))}}}$"
    decimals = max((_decimals(other) for other in others), default=0)
    return tr_number(minus(f"{value:.{decimals}f}" if decimals < 7 else f"{value:g}"))


def _decimals(value: float) -> int:
    return len(f"{value:.9f}".rstrip("0").partition(".")[2])


def room(values: Sequence[Real], above: float = 0.18, below: float = 0.12) -> tuple[float, float]:
    """The ends of an axis that shows these values with air around; 0 is among them."""
    low = min((float(np.min(each)) for each in values), default=0.0)
    high = max((float(np.max(each)) for each in values), default=0.0)
    noise = NOISE * max(abs(low), abs(high))
    low, high = min(low if low < -noise else 0.0, 0.0), max(high if high > noise else 0.0, 0.0)
    span = (high - low) or 1.0
    return low - below * span * (low < 0), high + above * span
