"""The key beside a blocking contour: what the numbers are, the points in figures, margins of the chosen shifts.

The column is measured in mm from its upper left corner; if all does not fit, everything shrinks alike.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.meshing.contours import UNBOUNDED, Area, ContourPoint, PairContour
from tmmcalc.gears.pictures.contourlines import Stroke, chosen, indexed, number_of
from tmmcalc.gears.pictures.contourlook import BELT, HATCHED, PALE, RING, STRICT, Look, marker, ring
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import extent, minus, wrapped
from tmmcalc.report.drawing.pens import INK, MARK
from tmmcalc.report.drawing.shapes import Area as Patch
from tmmcalc.report.drawing.shapes import Drawing, Hatching, Words
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit

SIZE = 2.0  # height of the text [mm]
HEADING = 2.5  # and of headings
LINE = 3.6  # height of a line of text [mm]
SPACE = 0.75  # between rows
SAMPLE = 8.0  # length of the sample of a line
PATCH = 10.5  # and of that of an area
LEFT = 13.5  # where the words begin
HEADS = ("$x_1$", "$x_2$", "$ε_α$", "$s_{a1}$", "$s_{a2}$", "$θ_1$", "$θ_2$")
COLUMNS = (11.0, 11.5, 9.5, 9.5, 9.5, 10.5, 10.5, 13.0)  # widths of the table [mm]
POINTS = 20.0  # where its columns begin
SLIDING = 5  # column of the first specific sliding
DECIMALS = (4, 4, 3, 3, 3, 2, 2, 3)
VALUES = (58.0, 74.0)  # right ends of the columns of margins
MARGINS = (
    ("undercut1", "undercut2"),
    ("tolerated1", "tolerated2"),
    ("interference1", "interference2"),
    ("thickness1", "thickness2"),
    ("contact_ratio", ""),
)
SAME = 1e-9  # difference of areas that is none
MINUS = minus("-")


@record
class Row:
    """A part of the column."""

    height: float  # [mm]
    draw: Callable[[float, float], None]  # at the y of its upper border, by the common shrinking


def write_key(drawing: Drawing, box: Box, pair: PairContour, seen: Sequence[Stroke]) -> None:
    """Write the column from the top of a rectangle; ``seen`` are the lines that the picture shows."""
    key = _Key(drawing, box)
    rows = [*key.lines(seen), *key.areas(pair), *key.points(pair), *key.chosen(pair, seen), *key.notes(pair)]
    shrink = min(1.0, box.height / sum(row.height for row in rows))
    y = box.top
    for row in rows:
        row.draw(y, shrink)
        y -= shrink * row.height


class _Key:
    """The rows of the column, which draw when their place is known."""

    def __init__(self, drawing: Drawing, box: Box) -> None:
        self.drawing, self.left, self.width = drawing, box.left, box.width

    def write(
        self, x: float, y: float, text: str, shrink: float, align: int = -1, colour: str = INK, size: float = SIZE
    ) -> None:
        """A line of text below y, x mm from the left of the column; all lines of a row have one base."""
        above, below = extent(text, shrink * size)
        middle = y - shrink * (LINE + size) / 2 + (above - below) / 2
        self.drawing.add(Words(complex(self.left + x, middle), text, shrink * size, align, colour=colour))

    def head(self, text: str) -> Row:
        """A heading."""
        return Row(2.2 + LINE, lambda y, k: self.write(0.0, y - k * 1.6, text, k, size=HEADING))

    def worded(self, text: str, left: float = 0.0, sign: Callable[[float, float], None] | None = None) -> Row:
        """Words in as many lines as they need, with a sign before them."""
        parts = wrapped(text, self.width - left, SIZE)
        height = LINE * len(parts) + SPACE

        def draw(y: float, k: float) -> None:
            if sign is not None:
                sign(y - k * (height - SPACE) / 2, k)
            for n, part in enumerate(parts):
                self.write(left, y - k * LINE * n, part, k)

        return Row(max(height, 2 * RING + SPACE), draw) if sign is not None else Row(height, draw)

    def lines(self, seen: Sequence[Stroke]) -> Iterator[Row]:
        """The lines that the picture shows."""
        if seen:
            yield self.head(tr("Lines"))
        for stroke in seen:
            yield self.worded(stroke.text, LEFT, self._sample(stroke))

    def _sample(self, stroke: Stroke) -> Callable[[float, float], None]:
        numbers = [text for text in stroke.number.split(", ") if text]
        within, _ = stroke.pens

        def draw(y: float, k: float) -> None:
            start = complex(self.left, y)
            self.drawing.line([start, start + (SAMPLE if len(numbers) < 2 else SAMPLE / 2)], within)
            for n, text in enumerate(reversed(numbers)):
                self.drawing.add(*ring(start + LEFT - 1.2 - RING - 2 * RING * n, text, within.colour, k))

        return draw

    def areas(self, pair: PairContour) -> Iterator[Row]:
        """What the areas are, with their sizes."""
        strict, tolerated = pair.strict, pair.tolerated
        if strict.main is not None or tolerated.main is not None:
            yield self.head(tr("Areas"))
        if strict.main is not None:
            text = tr("admissible without undercut, area {area}", area=_fixed(strict.main.area, 4))
            yield self.worded(text, LEFT, self._patch(STRICT, False))
        if tolerated.main is not None and (strict.main is None or tolerated.main.area > strict.main.area + SAME):
            text = tr(
                "admissible, not recommended: undercut that leaves the active flank whole; area of all {area}",
                area=_fixed(tolerated.main.area, 4),
            )
            yield self.worded(text, LEFT, self._patch(BELT, True))
        if strict.pieces or tolerated.pieces:
            text = tr("admissible beyond a pinch point, or apart: with a tip circle inside its reference circle")
            yield self.worded(text, LEFT, self._patch(PALE, not strict.pieces))

    def _patch(self, look: Look, hatched: bool) -> Callable[[float, float], None]:
        def draw(y: float, k: float) -> None:
            start, half = complex(self.left, y), 1.6j * k
            around = np.array([start - half, start + PATCH - half, start + PATCH + half, start + half])
            self.drawing.add(Patch(around, BELT.fill if hatched else look.fill))
            if hatched:
                self.drawing.add(Hatching((around,), pen=HATCHED))
            self.drawing.line(around, look.border, closed=True)

        return draw

    def points(self, pair: PairContour) -> Iterator[Row]:
        """The points in figures, and what each of them is."""
        if not pair.points:
            return
        yield self.head(tr("Points"))
        yield self._cells((*HEADS, f"$a_w$, {tr_unit('mm')}"), "", None)
        for point in pair.points:
            values = (point.x1, point.x2, point.contact_ratio, *point.tip_thickness, *point.sliding)
            every = zip((*values, 1e3 * point.distance), DECIMALS, strict=True)
            texts = [_fixed(value, decimals) for value, decimals in every]
            for k, theta in enumerate(point.sliding, start=SLIDING):
                if not theta:  # the flank would have to begin inside the base circle
                    texts[k] = "\N{EN DASH}"
                elif abs(theta) > UNBOUNDED:  # it begins on the base circle
                    texts[k] = f"{MINUS}\N{INFINITY}"
            yield self._cells(texts, tr_name(point.name), point)
        said = [
            f"{tr_name(point.name)}: {indexed(tr_name(point.title))}" for point in pair.points if point.name != "chosen"
        ]
        if said:
            yield self.worded("; ".join(said))

    def _cells(self, texts: Sequence[str], start: str, point: ContourPoint | None) -> Row:
        def draw(y: float, k: float) -> None:
            left = 0.0
            if point is not None:
                self.drawing.add(marker(point, complex(self.left + 1.2, y - k * LINE / 2)))
                left = 3.6
            self.write(left, y, start, k)
            for n, text in enumerate(texts):
                self.write(POINTS + sum(COLUMNS[: n + 1]), y, text, k, align=1)

        return Row(LINE + 0.6, draw)

    def chosen(self, pair: PairContour, seen: Sequence[Stroke]) -> Iterator[Row]:
        """Margins of the chosen shifts and how far x1 may go at their sum."""
        point = chosen(pair)
        if point is None:
            return
        where = tr("Chosen shifts: in the strict contour") if point.strict else tr("Chosen shifts: in the hatched belt")
        yield self.head(where if point.tolerated else tr("Chosen shifts: not admissible"))
        yield self._three(tr("margin"), tr("wheel {wheel}", wheel=1), tr("wheel {wheel}", wheel=2))
        names = (
            tr("no undercut"),
            tr("active flank whole"),
            tr("no interference"),
            tr("tip thickness"),
            tr("contact ratio"),
        )
        for text, (one, two) in zip(names, MARGINS, strict=True):
            values = [f"{_fixed(pair.margins[key], 4)}" if key in pair.margins else "" for key in (one, two)]
            numbers = ", ".join(dict.fromkeys(number_of(pair, key, seen) for key in (one, two) if key))
            yield self._three(f"{text} ({numbers})", *values)
        if pair.low is not None and pair.high is not None:
            ends = [number_of(pair, key, seen) if key else "" for key in pair.ends]
            low, high = (
                tr("{value} (line {number})", value=_fixed(x, 4), number=number) if number else _fixed(x, 4)
                for x, number in zip((pair.low, pair.high), ends, strict=True)
            )
            total = _fixed(point.x1 + point.x2, 4)
            text = tr("At the sum {sum} the shift x1 may be {low} to {high}.", sum=total, low=low, high=high)
            yield self.worded(indexed(text))

    def _three(self, text: str, one: str, two: str) -> Row:
        def draw(y: float, k: float) -> None:
            self.write(0.0, y, text, k)
            for x, value in zip(VALUES, (one, two), strict=True):
                self.write(x, y, value, k, align=1, colour=MARK.colour if value.startswith(MINUS) else INK)

        return Row(LINE + 0.2, draw)

    def notes(self, pair: PairContour) -> Iterator[Row]:
        """Reasons of what there is not."""
        strict, tolerated = (list(_reasons(area)) for area in (pair.strict, pair.tolerated))
        both = [text for text in tolerated if text in strict]
        found = [tr("strict contour: {reason}", reason=text) for text in strict if text not in tolerated]
        found += [tr("both contours: {reason}", reason=text) for text in both]
        found += [tr("tolerated contour: {reason}", reason=text) for text in tolerated if text not in strict]
        for points in pair.missing:
            found.append(f"{', '.join(map(tr_name, points.names))}: {tr_name(points.reason)}")
        for text in found:
            yield self.worded(indexed(f"{text[:1].upper()}{text[1:]}"))


def _fixed(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return tr_number(minus(text.lstrip("-") if not float(text) else text))


def _reasons(area: Area) -> Iterator[str]:
    if area.main is None:
        yield tr_name(area.reason)
    for wheel in area.untraced:
        yield tr("pieces with the tip of wheel {wheel} inside its reference circle are not drawn", wheel=3 - wheel)
