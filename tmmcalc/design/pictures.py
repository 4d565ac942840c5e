"""Pictures of sensitivities: bars of what one per cent of each key does, the longest first; curves over the rows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.courses import Course
from tmmcalc.design.sensitivity import Partial, Sensitivity
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, named
from tmmcalc.report.drawing.lettering import plain, width
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.panels import Panel, panels
from tmmcalc.report.drawing.pens import CURVES, THIN
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_measured, tr_unit
from tmmcalc.report.numbers import number

MOST = 20  # bars of a result
CURVED = 6  # keys of a diagram
PERCENT = 0.01
ROW, TALL, THICK = 8.0, 20.0, 0.62  # least and largest height of the row of a bar [mm], the part that the bar takes
UNDER, FRAMED = 12.0, 26.0  # room under a frame, and all beside its bars [mm]
LETTERS = 2.5  # height of the names of keys [mm]
WIDEST = 0.42  # of the sheet that names of keys may take
AIR = 1.15  # beyond the longest bar


def bars(result: Sensitivity) -> Drawing:
    """Bars of every result, to the right where more of a key gives more, of a kink half a bar to each side."""
    charts = [(name, value, _shown(result, name)) for name, value in zip(result.names, result.found, strict=True)]
    counts = [max(len(shown), 1) for _, _, shown in charts]
    needs = [FRAMED + ROW * count for count in counts]
    drawing, boxes = sheets(1)
    pages, room = [0], boxes[0].height
    for need in needs[1:]:
        used = sum(own for own, page in zip(needs, pages, strict=False) if page == pages[-1])
        pages.append(pages[-1] + (used + need > room))
    drawing, boxes = sheets(pages[-1] + 1)
    tops, rows = [box.top for box in boxes], [_row(room, page, counts, pages) for page in range(len(boxes))]
    for (name, value, shown), count, page in zip(charts, counts, pages, strict=True):
        need = FRAMED + rows[page] * count
        box = boxes[page]._replace(top=tops[page], bottom=max(tops[page] - need, boxes[page].bottom))
        tops[page] = box.bottom
        bare, unit = key_and_unit(name)
        title = tr("Sensitivity of {name} = {value}", name=plain(bare), value=tr_measured(number(value), unit))
        under = headed(drawing, box, title)
        if shown:
            _chart(drawing, under, shown, unit, rows[page])
        else:
            drawing.add(Words(complex(under.left, under.top), tr("no number matters"), LETTERS, -1 + 1j))
    return drawing


def _row(room: float, page: int, counts: Sequence[int], pages: Sequence[int]) -> float:
    """Height of a row [mm] by which the charts of a sheet fill it."""
    own = [count for count, at in zip(counts, pages, strict=True) if at == page]
    return min(TALL, max(ROW, (room - FRAMED * len(own)) / sum(own)))


def _shown(result: Sensitivity, name: str) -> list[Partial]:
    """Of a result the keys of which one per cent does most."""
    every = [each for each in result.of(name) if each.acts and max(map(abs, _changes(each))) > 0]
    return sorted(every, key=lambda each: -max(map(abs, _changes(each))))[:MOST]


def _changes(each: Partial) -> tuple[float, float]:
    """What one per cent more and one per cent less of a key do, by the derivative to each side; 0 where there is none.

    One per cent less is told by what it would be as more, so that both are alike where there is no kink.
    """
    step = PERCENT * each.value
    right, left = (each.slope.right, each.slope.left) if each.slope.side == "kink" else 2 * (each.slope.value,)
    one, other = (float(side * step) if np.isfinite(side) else 0.0 for side in (right, left))
    return one, other


def _chart(drawing: Drawing, box: Box, shown: Sequence[Partial], unit: str, row: float) -> None:
    names = [plain(key_and_unit(each.key)[0]) for each in shown]
    size = LETTERS * min(1.0, WIDEST * box.width / max(width(name, LETTERS) for name in names))
    left = max(width(name, size) for name in names) + 4.0
    high = min(box.height - UNDER, row * len(shown))
    frame = Box(box.left + left, box.top - high, box.right - 2.0, box.top)
    most = AIR * max(abs(change) for each in shown for change in _changes(each))
    label = tr("change for 1 % of the key, {unit}", unit=tr_unit(unit)) if unit else tr("change for 1 % of the key")
    along, up = Axis(label, -most, most), Axis("", 0.0, float(len(shown)))
    diagram = Diagram(drawing, frame, along, up, lettered=False)
    for k, (each, name) in enumerate(zip(shown, names, strict=True)):
        middle = len(shown) - k - 0.5
        drawing.add(Words(complex(frame.left - 2.0, diagram.place(1j * middle).imag), name, size, 1))
        parts = _changes(each)
        halves = ((0.0, THICK / 2), (-THICK / 2, 0.0)) if each.slope.side == "kink" else ((-THICK / 2, THICK / 2),)
        for change, (low, top) in zip(parts, halves, strict=False):
            corners = [0, change, change + 1j * (top - low), 1j * (top - low)]
            pen = CURVES[0] if change > 0 else CURVES[1]
            drawing.add(Area(diagram.paper([1j * (middle + low) + each for each in corners]), pen.colour))
    drawing.line(diagram.paper([0j, 1j * len(shown)]), THIN)


def curves(every: Sequence[Course]) -> Drawing:
    """A sheet a column: its values, and what one per cent of the keys that matter most does to it in every row."""
    drawing, boxes = sheets(len(every))
    for box, course in zip(boxes, every, strict=True):
        bare, unit = key_and_unit(course.column)
        under = headed(drawing, box, tr("Sensitivity of {name} over its rows", name=plain(bare)))
        told = tuple(
            (plain(key_and_unit(own[0].key)[0]), np.array([_changes(each)[0] for each in own]))
            for own in course.telling[:CURVED]
        )
        column, said = plain(bare.rpartition(".")[2]), tr_unit(unit)
        rows = [Panel(f"{column}, {said}" if unit else column, ((column, np.array(course.values)),))]
        if told:
            label = tr("change for 1 % of the key, {unit}", unit=said) if unit else tr("change for 1 % of the key")
            rows.append(Panel(label, told))
        x = np.array(course.x)
        turns = key_and_unit(course.over)[1] == "deg"
        ends = Axis(named(course.over) or tr("row"), float(np.min(x)), float(np.max(x)), degrees=turns)
        panels(drawing, under, x, ends, rows, (1.0, 1.6)[: len(rows)])
    return drawing
