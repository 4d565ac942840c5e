"""The key beside a blocking contour: what the numbers are, the points in figures, margins of the chosen shifts.

The column is measured in mm from its upper left corner; if all does not fit, everything shrinks alike.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from textwrap import wrap
from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import Circle, Rectangle

from tmmcalc.core.records import record
from tmmcalc.gears.meshing.contours import UNBOUNDED, Area, ContourPoint, PairContour
from tmmcalc.gears.pictures.contourlines import Stroke, chosen, indexed, number_of
from tmmcalc.gears.pictures.contourlook import BELT, BORDER, FILL, FONT, HATCH, PALE, RING, STRICT, STROKES, marker_of
from tmmcalc.report.drawing.labels import MM
from tmmcalc.report.drawing.style import INK, MARK

SIZE = 7.0  # of the text [points]
WIDE = 0.52  # mean width of a letter, in parts of its size
LINE = 3.35  # height of a line of text [mm]
SPACE = 0.75  # between rows
SAMPLE = 8.0  # length of the sample of a line
LEFT = 13.5  # where the words begin
HEADS = (
    "$x_1$",
    "$x_2$",
    "$\\varepsilon_\\alpha$",
    "$s_{a1}$",
    "$s_{a2}$",
    "$\\vartheta_1$",
    "$\\vartheta_2$",
    "$a_w$, mm",
)
COLUMNS = (11.0, 11.5, 9.5, 10.0, 9.5, 11.0, 11.0, 13.0)  # widths of the table [mm]
SLIDING = 5  # column of the first specific sliding
DECIMALS = (4, 4, 3, 3, 3, 2, 2, 3)
MARGINS = (
    ("no undercut", "undercut1", "undercut2"),
    ("active flank whole", "tolerated1", "tolerated2"),
    ("no interference", "interference1", "interference2"),
    ("tip thickness", "thickness1", "thickness2"),
    ("contact ratio", "contact_ratio", ""),
)
SAME = 1e-9  # difference of areas that is none
MINUS = "\N{MINUS SIGN}"


@record
class Row:
    """A part of the column."""

    height: float  # [mm]
    draw: Callable[[float, float], None]  # at the y of its upper border, by the common shrinking


def write_key(axes: Axes, pair: PairContour, seen: Sequence[Stroke]) -> None:
    """Write the column, whose place must be settled; ``seen`` are the lines that the picture shows."""
    box = axes.get_window_extent()
    width, height = (v * MM / axes.figure.dpi for v in (box.width, box.height))
    axes.set_xlim(0, width)
    axes.set_ylim(-height, 0)
    rows = [
        *_lines(axes, seen, width),
        *_areas(axes, pair, width),
        *_points(axes, pair, width),
        *_chosen(axes, pair, seen, width),
    ]
    rows += _notes(axes, pair, width)
    shrink = min(1.0, height / sum(row.height for row in rows))
    y = 0.0
    for row in rows:
        row.draw(y, shrink)
        y -= shrink * row.height


def _head(axes: Axes, text: str) -> Row:
    return Row(2.0 + LINE, lambda y, k: _write(axes, 0.0, y - k * 1.6, text, k, weight="bold"))


def _write(axes: Axes, x: float, y: float, text: str, shrink: float, **style: Any) -> None:
    """A line of text below y."""
    style = {"ha": "left", "va": "center_baseline", "color": INK, **style}
    axes.text(x, y - shrink * LINE / 2, text, fontsize=shrink * SIZE, **style)


def _worded(axes: Axes, text: str, width: float, left: float, sign: Callable[[float, float], None] | None) -> Row:
    """Words in as many lines as they need, with a sign before them."""
    parts = wrap(text, int((width - left) / (WIDE * SIZE * MM / 72))) or [""]
    height = LINE * len(parts) + SPACE

    def draw(y: float, k: float) -> None:
        if sign is not None:
            sign(y - k * (height - SPACE) / 2, k)
        for n, part in enumerate(parts):
            _write(axes, left, y - k * LINE * n, part, k)

    return Row(max(height, 2 * RING + SPACE), draw) if sign is not None else Row(height, draw)


def _lines(axes: Axes, seen: Sequence[Stroke], width: float) -> Iterator[Row]:
    if seen:
        yield _head(axes, "Lines")
    for stroke in seen:
        yield _worded(axes, stroke.text, width, LEFT, _sample(axes, stroke))


def _sample(axes: Axes, stroke: Stroke) -> Callable[[float, float], None]:
    numbers = [text for text in stroke.number.split(", ") if text]

    def draw(y: float, k: float) -> None:
        axes.plot([0, SAMPLE if len(numbers) < 2 else SAMPLE / 2], [y, y], linewidth=1.2, **stroke.look)
        for n, text in enumerate(reversed(numbers)):
            x = LEFT - 1.2 - RING - 2 * RING * n
            axes.add_patch(Circle((x, y), k * RING, facecolor="white", edgecolor=stroke.look["color"], linewidth=0.7))
            axes.text(x, y, text, ha="center", va="center_baseline", fontsize=k * FONT, color=INK)

    return draw


def _areas(axes: Axes, pair: PairContour, width: float) -> Iterator[Row]:
    strict, tolerated = pair.strict, pair.tolerated
    if strict.main is not None or tolerated.main is not None:
        yield _head(axes, "Areas")
    if strict.main is not None:
        text = f"admissible without undercut, area {strict.main.area:.4f}"
        yield _worded(axes, text, width, LEFT, _swatch(axes, STRICT, False))
    if tolerated.main is not None and (strict.main is None or tolerated.main.area > strict.main.area + SAME):
        text = "admissible, not recommended: undercut that leaves the active flank whole; "
        text += f"area of all {tolerated.main.area:.4f}"
        yield _worded(axes, text, width, LEFT, _swatch(axes, BELT, True))
    if strict.pieces or tolerated.pieces:
        text = "admissible beyond a pinch point, or apart: with a tip circle inside its reference circle"
        yield _worded(axes, text, width, LEFT, _swatch(axes, PALE, not strict.pieces))


def _swatch(axes: Axes, look: dict[str, dict[str, Any]], hatched: bool) -> Callable[[float, float], None]:
    def draw(y: float, k: float) -> None:
        high, wide = 1.6 * k, 10.5
        line = look[BORDER]
        fill = BELT[FILL] if hatched else look[FILL]
        outline = {"edgecolor": line["color"], "linewidth": line["linewidth"]}
        axes.add_patch(Rectangle((0, y - high), wide, 2 * high, **fill | outline))
        if hatched:
            for n in range(int((wide - 2 * high) / HATCH) + 1):
                x = n * HATCH
                axes.plot([x, x + 2 * high], [y - high, y + high], color=BELT[STROKES]["colors"], linewidth=0.5)

    return draw


def _points(axes: Axes, pair: PairContour, width: float) -> Iterator[Row]:
    if not pair.points:
        return
    yield _head(axes, "Points")
    places = [LEFT + 8.5 + sum(COLUMNS[: k + 1]) for k in range(len(COLUMNS))]

    def cells(texts: Sequence[str], start: str, point: ContourPoint | None) -> Row:
        def draw(y: float, k: float) -> None:
            left = 0.0
            if point is not None:
                axes.plot(1.2, y - k * LINE / 2, **marker_of(point))
                left = 3.6
            _write(axes, left, y, start, k)
            for x, text in zip(places, texts, strict=True):
                _write(axes, x, y, text, k, ha="right")

        return Row(LINE + 0.6, draw)

    yield cells(HEADS, "", None)
    for point in pair.points:
        values = (point.x1, point.x2, point.contact_ratio, *point.tip_thickness, *point.sliding, 1e3 * point.distance)
        texts = [_fixed(v, n) for v, n in zip(values, DECIMALS, strict=True)]
        for k, theta in enumerate(point.sliding, start=SLIDING):
            if not theta:  # the flank would have to begin inside the base circle
                texts[k] = "\N{EN DASH}"
            elif abs(theta) > UNBOUNDED:
                texts[k] = f"{MINUS}\N{INFINITY}"
        yield cells(texts, point.name, point)
    said = [f"{point.name}: {indexed(point.title)}" for point in pair.points if point.name != "chosen"]
    if said:
        yield _worded(axes, "; ".join(said), width, 0.0, None)


def _fixed(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return (text.lstrip("-") if not float(text) else text).replace("-", MINUS)


def _chosen(axes: Axes, pair: PairContour, seen: Sequence[Stroke], width: float) -> Iterator[Row]:
    """Margins of the chosen shifts and how far x1 may go at their sum."""
    point = chosen(pair)
    if point is None:
        return
    where = "in the strict contour" if point.strict else "in the hatched belt"
    yield _head(axes, f"Chosen shifts: {where if point.tolerated else 'not admissible'}")
    yield _three(axes, "margin", "wheel 1", "wheel 2")
    for text, one, two in MARGINS:
        values = [f"{_fixed(pair.margins[key], 4)}" if key in pair.margins else "" for key in (one, two)]
        numbers = ", ".join(dict.fromkeys(number_of(pair, key, seen) for key in (one, two) if key))
        yield _three(axes, f"{text} ({numbers})", *values)
    if pair.low is not None and pair.high is not None:
        ends = [number_of(pair, key, seen) if key else "" for key in pair.ends]
        low, high = (
            f"{_fixed(x, 4)} (line {number})" if number else _fixed(x, 4)
            for x, number in zip((pair.low, pair.high), ends, strict=True)
        )
        text = indexed(f"At the sum {_fixed(point.x1 + point.x2, 4)} the shift x1 may be {low} to {high}.")
        yield _worded(axes, text, width, 0.0, None)


def _three(axes: Axes, text: str, one: str, two: str) -> Row:
    def draw(y: float, k: float) -> None:
        _write(axes, 0.0, y, text, k)
        for x, value in ((58.0, one), (74.0, two)):
            _write(axes, x, y, value, k, ha="right", color=MARK if value.startswith(MINUS) else INK)

    return Row(LINE + 0.2, draw)


def _notes(axes: Axes, pair: PairContour, width: float) -> Iterator[Row]:
    """Reasons of what there is not."""
    strict, tolerated = (list(_reasons(area)) for area in (pair.strict, pair.tolerated))
    found = [f"strict contour: {text}" for text in strict if text not in tolerated]
    found += [f"{'both contours' if text in strict else 'tolerated contour'}: {text}" for text in tolerated]
    found += pair.missing
    for text in found:
        yield _worded(axes, indexed(f"{text[:1].upper()}{text[1:]}"), width, 0.0, None)


def _reasons(area: Area) -> Iterator[str]:
    if area.main is None:
        yield area.reason
    for wheel in area.untraced:
        yield f"pieces with the tip of wheel {3 - wheel} inside its reference circle are not drawn"
