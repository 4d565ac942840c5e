"""Frame and title block of the pages of a text by GOST 2.104: form 2 on the first, form 2a on all others."""

from __future__ import annotations

from itertools import accumulate
from typing import NamedTuple

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pens import BLOCK, FRAME
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.cells import caption, filled_in

PAGE = (210.0, 297.0)  # [mm]
LEFT, ELSEWHERE = 20.0, 5.0  # margins [mm]
WIDTHS = (7.0, 10.0, 23.0, 15.0, 10.0)  # of the columns at the left [mm]
EDGES = (0.0, *accumulate(WIDTHS))
ROW = 5.0
WIDE = 185.0
FIRST, OTHERS = 40.0, 15.0  # heights of the title blocks


class TextTitles(NamedTuple):
    """What stands in the title block."""

    title: str
    designation: str
    done_by: str
    checked_by: str
    organisation: str


def text_frame(titles: TextTitles, first: bool) -> tuple[Drawing, Box, Box | None]:
    """An empty page with its frame; the cells of its number and, on the first page, of the number of pages."""
    drawing = Drawing(*PAGE)
    drawing.line(Box(LEFT, ELSEWHERE, PAGE[0] - ELSEWHERE, PAGE[1] - ELSEWHERE).corners, FRAME, closed=True)
    height = FIRST if first else OTHERS
    _line(drawing, 0, height, WIDE, height)
    heads = 25.0 if first else 0.0  # where the row of captions begins
    _line(drawing, EDGES[1], heads, EDGES[1], height)
    for edge in EDGES[2:]:
        _line(drawing, edge, 0, edge, height)
    for y in range(1, round(height / ROW)):
        thick = not first or y * ROW in (heads, heads + ROW)
        drawing.line([_at(0, y * ROW), _at(EDGES[-1], y * ROW)], FRAME if thick else BLOCK)
    words = (tr("Rev."), tr("Sh."), tr("Doc. No."), tr("Sign."), tr("Date"))
    for left, right, text in zip(EDGES[:5], EDGES[1:], words, strict=True):
        caption(drawing, _cell(left, heads, right, heads + ROW), text)
    return (drawing, *(_first(drawing, titles) if first else _other(drawing, titles)))


def _first(drawing: Drawing, titles: TextTitles) -> tuple[Box, Box]:
    """The right part of form 2."""
    _line(drawing, 65, 25, WIDE, 25)
    _line(drawing, 135, 0, 135, 25)
    for y in (15, 20):
        _line(drawing, 135, y, WIDE, y)
    for x in (150, 165):
        _line(drawing, x, 15, x, 25)
    for x in (140, 145):
        drawing.line([_at(x, 15), _at(x, 20)], BLOCK)
    filled_in(drawing, _cell(65, 25, WIDE, FIRST), titles.designation)
    filled_in(drawing, _cell(65, 0, 135, 25), f"{titles.title}. {tr('Explanatory note')}", height=5.0)
    filled_in(drawing, _cell(135, 0, WIDE, 15), titles.organisation, height=5.0)
    for left, right, text in ((135, 150, tr("Letter")), (150, 165, tr("Sheet")), (165, 185, tr("Sheets"))):
        caption(drawing, _cell(left, 20, right, 25), text)
    rows = ((tr("Drawn"), titles.done_by), (tr("Checked"), titles.checked_by), ("", ""), (tr("Stand. ctrl."), ""))
    for k, (role, name) in enumerate((*rows, (tr("Approved"), ""))):
        if role:
            caption(drawing, _cell(0, 20 - ROW * k, 17, 25 - ROW * k), role, align=-1 + 0j)
        filled_in(drawing, _cell(17, 20 - ROW * k, 40, 25 - ROW * k), name, height=3.5, align=-1 + 0j, most=1)
    return _cell(150, 15, 165, 20), _cell(165, 15, WIDE, 20)


def _other(drawing: Drawing, titles: TextTitles) -> tuple[Box, None]:
    """The right part of form 2a."""
    _line(drawing, 175, 0, 175, OTHERS)
    _line(drawing, 175, 8, WIDE, 8)
    filled_in(drawing, _cell(65, 0, 175, OTHERS), titles.designation)
    caption(drawing, _cell(175, 8, WIDE, OTHERS), tr("Sh."))
    return _cell(175, 0, WIDE, 8), None


def _line(drawing: Drawing, left: float, low: float, right: float, high: float) -> None:
    drawing.line([_at(left, low), _at(right, high)], FRAME)


def _at(x: float, y: float) -> complex:
    """A place by its distance from the lower left corner of the title block."""
    return complex(PAGE[0] - ELSEWHERE - WIDE + x, ELSEWHERE + y)


def _cell(left: float, low: float, right: float, high: float) -> Box:
    corner, other = _at(left, low), _at(right, high)
    return Box(corner.real, corner.imag, other.real, other.imag)
