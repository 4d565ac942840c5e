"""The picture of the transloader: speeds over the time of a way, the loads of each case, stresses of the parts."""

from __future__ import annotations

import numpy as np

from tmmcalc.extras.loadcases import CASES
from tmmcalc.extras.transloader import MINUTE, Drive, Transloader
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import HEIGHT, ROW, Axis, key_above, key_rows, ticks, written
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, panels
from tmmcalc.report.drawing.pens import CURVES, GRID, MARK, PLATE, THIN, WHITE, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

ALLOWED = Pen("ALLOWED", 0.7, colour=MARK.colour)
OTHER = Pen("ALLOWED_OTHER", 0.5, colour="#8a8a8a")
CELL = Pen("TABLE", 0.18, colour=THIN.colour)


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return transloader_drawing(order.results["transloader"])


def transloader_drawing(result: Transloader) -> Drawing:
    """Ways of trolley and hoist above, the loads of the cases and the stresses of the parts below."""
    drawing, box = titled(tr("Grab transloader"))
    below = box
    if result.drives:
        above, below = box.split(1, 1.4, gap=3)
        draw_ways(drawing, above, result)
    parts = below.split(1, 1, gap=5, across=True) if result.checks else [below]
    _loads(drawing, parts[0], result)
    if result.checks:
        draw_stresses(drawing, parts[1], result)
    return drawing


def draw_ways(drawing: Drawing, box: Box, result: Transloader, *, across: bool = True) -> None:
    """Speeds of trolley and hoist over the time of a way, side by side or one under another."""
    parts = box.split(*(1.0 for _ in result.drives), gap=5, across=across)
    for part, drive in zip(parts, result.drives, strict=True):
        _way(drawing, part, drive)


def _way(drawing: Drawing, box: Box, drive: Drive) -> None:
    """The speed over the time, beside the way that is nothing but acceleration and braking."""
    top, reached = drive.shortest / 2, min(drive.speed, drive.peak)
    t = np.array(sorted({0.0, top, drive.shortest, reached / drive.acceleration, drive.time}))
    t = np.unique(np.concatenate((t, drive.time - t[t <= drive.time])))
    t = t[t >= 0]
    rising = MINUTE * drive.acceleration
    slow = np.clip(np.minimum(rising * np.minimum(t, drive.time - t), MINUTE * reached), 0.0, None)
    fast = np.clip(rising * np.minimum(t, drive.shortest - t), 0.0, None)
    time, shortest = number(drive.time, 3), number(drive.shortest, 3)
    way = tr("trolley, {time} s", time=time) if drive.what == "trolley" else tr("hoist, {time} s", time=time)
    lines = ((way, slow), (tr("up to the peak, {time} s", time=shortest), fast))
    panels(drawing, box, t, f"$t$, {tr_unit('s')}", [Panel(f"$v$, {tr_unit('m/min')}", lines)])


def _loads(drawing: Drawing, box: Box, result: Transloader) -> None:
    """A cell for each load and case: its size where it acts."""
    names = [meaning_of(each.load) for each in result.loads]
    drawing.add(Words(complex(box.middle.real, box.top), tr("loads by case, kN"), 2.5, 1j))
    frame = box.inset(max(width(name, 2.0) for name in names) + 2, 6, 1, 7)
    wide, high = frame.width / len(CASES), frame.height / len(names)
    for row, (load, name) in enumerate(zip(result.loads, names, strict=True)):
        y = frame.top - (row + 0.5) * high
        drawing.add(Words(complex(frame.left - 1.5, y), name, min(2.0, 0.5 * high), 1))
        for column, case in enumerate(CASES):
            acting, left_blank = case in load.cases, case in load.blank
            at = complex(frame.left + (column + 0.5) * wide, y)
            cell = at + np.array([complex(s * wide / 2, t * high / 2) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
            drawing.add(Area(cell, PLATE if acting else WHITE, CELL))
            text = (number(load.value / 1000, 4) if acting else "") + ("?" if left_blank else "")
            if text:
                drawing.add(Words(at, text, min(2.0, 0.5 * high, 0.9 * wide / width(text))))
    for column, case in enumerate(CASES):
        drawing.add(Words(complex(frame.left + (column + 0.5) * wide, frame.bottom - 1.5), case, 2.0, 1j))


def draw_stresses(drawing: Drawing, box: Box, result: Transloader) -> None:
    """Bars of the stresses, with what is allowed as marks."""
    names = [
        tr("{part}, {case} endurance", part=tr_name(each.part), case=each.case)
        if each.kind == "endurance"
        else tr("{part}, {case} strength", part=tr_name(each.part), case=each.case)
        for each in result.checks
    ]
    rows = [(1e-6 * each.stress, 1e-6 * each.allowed, 1e-6 * each.other) for each in result.checks]
    both = [tr("allowed, sum of factors"), tr("allowed, product of factors")]
    own, other_name = both if result.factors == "sum" else both[::-1]
    bars = Pen("BARS", 1.4, colour=CURVES[0].colour)
    key = [(tr("stress"), bars), (own, ALLOWED), (other_name, OTHER)]
    left = max(width(name, 2.0) for name in names) + 2
    frame = box.inset(left, 11, 2, ROW * len(key_rows(key, box.width - left - 2)) + 3)
    top = 1.08 * max(max(row) for row in rows)
    axis, unit, high = Axis(tr("stress, MPa"), 0.0, top), frame.width / top, frame.height / len(rows)
    values = ticks(axis, max(2, int(frame.width / 14)))
    for value in values:
        x = frame.left + value * unit
        drawing.line([complex(x, frame.bottom), complex(x, frame.top)], GRID, level=-1)
        drawing.add(Words(complex(x, frame.bottom - 1.5), written(value, values), 2.2, 1j))
    for row, ((stress, allowed, other), name) in enumerate(zip(rows, names, strict=True)):
        y, half = frame.top - (row + 0.5) * high, 0.3 * high
        end = frame.left + stress * unit
        corners = [complex(frame.left, y - half), complex(end, y - half), complex(end, y + half)]
        drawing.add(Area(np.array([*corners, complex(frame.left, y + half)]), CURVES[0].colour))
        drawing.add(Words(complex(frame.left - 1.5, y), name, min(2.0, 0.5 * high), 1))
        for value, pen, reach in ((other, OTHER, 0.3), (allowed, ALLOWED, 0.42)):
            x = frame.left + value * unit
            drawing.line([complex(x, y - reach * high), complex(x, y + reach * high)], pen, level=2)
    outline = [complex(frame.left, frame.bottom), complex(frame.right, frame.bottom)]
    drawing.line([*outline, complex(frame.right, frame.top), complex(frame.left, frame.top)], THIN, closed=True)
    drawing.add(Words(complex(frame.middle.real, frame.bottom - 5.5), axis.name, HEIGHT, 1j))
    key_above(drawing, frame, key)


def meaning_of(load: str) -> str:
    """What a load is."""
    names = {
        "dead_weight": tr("dead weight"),
        "rated_load": tr("rated load"),
        "inertia": tr("inertia in normal operation"),
        "equivalent_wind": tr("equivalent wind"),
        "track": tr("track gradient, rocking of the crane"),
        "drive": tr("largest moments of drives, skidding, their inertia"),
        "hurricane": tr("hurricane wind"),
    }
    return names.get(load) or tr_name(load)
