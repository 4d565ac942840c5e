"""The frame of GOST 2.301 and the title block of GOST 2.104, form 1, with the designation turned in a corner."""

from __future__ import annotations

import math
from itertools import accumulate

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import plain, width
from tmmcalc.report.drawing.pens import BLOCK, FRAME, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.cells import AIR, caption, filled_in
from tmmcalc.report.sheets.titles import Titles

LEFT, ELSEWHERE = 20.0, 5.0  # margins [mm]
COLUMNS = (7, 10, 23, 15, 10, 70, 5, 5, 5, 5, 12, 18)  # widths [mm]
ROW, ROWS = 5.0, 11
SIZE = (185.0, 55.0)
CORNER = (70.0, 14.0)  # of the graph of the turned designation
EDGES = (0, *accumulate(COLUMNS))  # 0, 7, 17, 40, 55, 65, 135, 140, 145, 150, 155, 167, 185


def frame(drawing: Drawing, titles: Titles) -> Box:
    """Draw frame, title block and the graph above; the rectangle inside the frame."""
    box = Box(LEFT, ELSEWHERE, drawing.width - ELSEWHERE, drawing.height - ELSEWHERE)
    drawing.line(box.corners, FRAME, closed=True)
    corner = Box(box.left, box.top - CORNER[1], box.left + CORNER[0], box.top)
    drawing.line([corner.corners[0], corner.corners[1], corner.corners[2]], FRAME)
    _turned(drawing, corner, titles.designation)
    block = Box(box.right - SIZE[0], box.bottom, box.right, box.bottom + SIZE[1])
    _lines(drawing, block)
    _captions(drawing, block)
    _entries(drawing, block, titles)
    below = Box(block.right - 50, 0, block.right, ELSEWHERE)
    caption(drawing, below, tr("Format {name}", name=titles.format.upper()), align=1 + 0j)
    return box


def _turned(drawing: Drawing, corner: Box, designation: str) -> None:
    """The designation upside down, so that it is read from above in a folder."""
    if designation:
        size = 7.0 * min(1.0, (corner.width - 4 * AIR) / width(plain(designation), 7.0))
        drawing.add(Words(corner.middle, plain(designation), size, turn=math.pi))


def _lines(drawing: Drawing, block: Box) -> None:
    """The true lines of the form; places from its lower left corner [mm]."""
    drawing.line(block.corners, FRAME, closed=True)
    across: tuple[tuple[float, float, float, Pen], ...] = (
        *((ROW * k, 0, 65, FRAME if k in (6, 7) else BLOCK) for k in range(1, ROWS)),
        *((y, 65, 185, FRAME) for y in (15, 40)),
        *((y, 135, 185, FRAME) for y in (20, 35)),
    )
    for y, left, right, pen in across:
        drawing.line([_at(block, left, y), _at(block, right, y)], pen)
    upward: tuple[tuple[float, float, float, Pen], ...] = (
        (7, 30, 55, FRAME),
        *((x, 0, 55, FRAME) for x in (17, 40, 55, 65)),
        (135, 0, 40, FRAME),
        *((x, 20, 40, FRAME) for x in (150, 167)),
        *((x, 20, 35, BLOCK) for x in (140, 145)),
        (155, 15, 20, FRAME),
    )
    for x, low, high, pen in upward:
        drawing.line([_at(block, x, low), _at(block, x, high)], pen)


def _captions(drawing: Drawing, block: Box) -> None:
    heads = (tr("Rev."), tr("Sh."), tr("Doc. No."), tr("Sign."), tr("Date"))
    for left, right, text in zip(EDGES[:5], EDGES[1:6], heads, strict=True):
        caption(drawing, _cell(block, left, 30, right, 35), text)
    roles = (tr("Drawn"), tr("Checked"), tr("Techn. ctrl."), "", tr("Stand. ctrl."), tr("Approved"))
    for k, text in enumerate(roles):
        if text:
            caption(drawing, _cell(block, 0, 25 - ROW * k, 17, 30 - ROW * k), text, align=-1 + 0j)
    for left, right, text in ((135, 150, tr("Letter")), (150, 167, tr("Mass")), (167, 185, tr("Scale"))):
        caption(drawing, _cell(block, left, 35, right, 40), text)


def _entries(drawing: Drawing, block: Box, titles: Titles) -> None:
    who = titles.who
    filled_in(drawing, _cell(block, 65, 40, 185, 55), titles.designation, most=1)
    filled_in(drawing, _cell(block, 65, 27, 135, 40), titles.title, height=5.0)
    filled_in(drawing, _cell(block, 65, 15, 135, 27), titles.name, height=5.0)
    filled_in(drawing, _cell(block, 65, 0, 135, 15), who.material, height=5.0)
    filled_in(drawing, _cell(block, 135, 0, 185, 15), who.organisation, height=5.0)
    filled_in(drawing, _cell(block, 135, 20, 140, 35), who.letter, height=3.5)
    people = (who.drawn_by, who.checked_by, who.technical_control, "", who.standards_control, who.approved_by)
    for k, name in enumerate(people):
        filled_in(drawing, _cell(block, 17, 25 - ROW * k, 40, 30 - ROW * k), name, height=3.5, align=-1 + 0j)
    filled_in(drawing, _cell(block, 55, 25, 65, 30), who.date, height=2.5)
    caption(drawing, _cell(block, 135, 15, 155, 20), tr("Sheet {number}", number=titles.number))
    caption(drawing, _cell(block, 155, 15, 185, 20), tr("Sheets {count}", count=titles.total))


def _at(block: Box, x: float, y: float) -> complex:
    return complex(block.left + x, block.bottom + y)


def _cell(block: Box, left: float, bottom: float, right: float, top: float) -> Box:
    return Box(block.left + left, block.bottom + bottom, block.left + right, block.bottom + top)
