"""Panels with logarithmic axes, six to a sheet: rows of points, joined by lines, with their names under the frame."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, sign
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Drawing, Words

COLUMNS, ROWS = 3, 2  # of panels on a sheet
HEADING = 7.0  # room of the heading [mm]
MARKS = "osD^vP*X"
NAME, SAMPLE = 1.9, 8.0  # height of the names, length of a line beside one [mm]
AIR = 0.06  # of the decades, beyond the outermost points
LEAST = 1.0  # decades that an axis spans


@record
class Dots:
    """Points with their name; without a mark the line alone, without a name not in the key."""

    name: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    pen: Pen
    mark: str


def pages(count: int, heading: str) -> tuple[Drawing, list[Box]]:
    """Sheets for so many panels, and the places of these."""
    drawing, boxes = sheets(max(-(-count // (COLUMNS * ROWS)), 1), heading)
    columns = 2 if count == 4 else min(max(count, 1), COLUMNS)
    rows = ROWS if count > columns else 1
    places: list[Box] = []
    for box in boxes:
        drawing.add(Words(complex(box.middle.real, box.top), heading.replace("$", "\\$"), 3.2, 1j))
        for row in box.inset(0, 0, 0, HEADING).split(*(1.0 for _ in range(rows)), gap=3):
            places += row.split(*(1.0 for _ in range(columns)), gap=4, across=True)
    return drawing, places[:count]


def framed(
    drawing: Drawing,
    box: Box,
    names: tuple[str, str, str],
    curves: Sequence[Dots],
    levels: Sequence[tuple[float, Pen]],
    *,
    ends: tuple[tuple[float, float], tuple[float, float]] | None = None,
    key: Sequence[tuple[str, Pen]] = (),
    linear: bool = False,
) -> Diagram:
    """One panel: title and axes by ``names``, the curves, levels across; the key with more names under it."""
    title, across, up = names
    if ends is None:
        heights = [v for curve in curves for v in curve.y] + [level for level, _ in levels]
        ends = _span([v for curve in curves for v in curve.x], linear), _span(heights, False)
    told = [(curve.name, curve.pen, curve.mark) for curve in curves if curve.name]
    told += [(name, pen, "") for name, pen in key]
    wide = max((width(name, NAME) for name, *_ in told), default=0.0) + SAMPLE + 4
    columns = max(1, min(len(told), int(box.width / wide)))
    rows = -(-len(told) // columns)
    frame = box.inset(16, 12 + 1.8 * NAME * rows, 2, 6)
    drawing.add(Words(complex(frame.middle.real, box.top), title, 2.8, 1j))
    field = Diagram(drawing, frame, Axis(across, *ends[0], log=not linear), Axis(up, *ends[1], log=True))
    for level, pen in levels:
        field.level(level, pen)
    for curve in curves:
        y = np.maximum(curve.y, ends[1][0])
        if len(curve.x):
            field.curve(np.array(curve.x) + 1j * y, curve.pen)
        for at in zip(curve.x, y.tolist(), strict=True) if curve.mark else ():
            field.marker(complex(*at), curve.mark, curve.pen, 1.3)
    for k, (name, pen, mark) in enumerate(told):
        column, row = k % columns, k // columns
        place = complex(box.left + column * box.width / columns + 2, frame.bottom - 12 - (row + 0.5) * 1.8 * NAME)
        drawing.line([place, place + SAMPLE], pen)
        if mark:
            sign(drawing, place + SAMPLE / 2, mark, pen, 1.3)
        drawing.add(Words(place + SAMPLE + 1.2, name, NAME, -1))
    return field


def _span(values: Sequence[float], linear: bool) -> tuple[float, float]:
    """Ends of an axis around all values."""
    if linear:
        low, high = min(values, default=0.0), max(values, default=1.0)
        air = AIR * (high - low) or 1.0
        return low - air, high + air
    decades = np.log10([value for value in values if value > 0] or [1.0])
    low, high = float(np.min(decades)), float(np.max(decades))
    half = max((high - low) * (1 + 2 * AIR), LEAST) / 2
    middle = (low + high) / 2
    return float(10 ** (middle - half)), float(10 ** (middle + half))
