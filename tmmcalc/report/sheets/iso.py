"""The frame of ISO 5457, with zones and centring marks, and a title block of ISO 7200."""

from __future__ import annotations

import math
from itertools import pairwise

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pens import BLOCK, FRAME, ZONES
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import spoken, tr
from tmmcalc.report.sheets.cells import AIR, caption, filled_in
from tmmcalc.report.sheets.titles import Titles

LEFT, ELSEWHERE = 20.0, 10.0  # margins [mm]
BORDER = 5.0  # width of the border with the zones
ZONE = 50.0  # length of a zone; those at the corners take the rest
MARK = 10.0  # length of a centring mark, from the outside of that border
LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ"  # without I and O
SIZE = (180.0, 36.0)  # of the title block
ROW = 9.0


def frame(drawing: Drawing, titles: Titles) -> Box:
    """Draw frame and title block; the rectangle inside the frame."""
    box = Box(LEFT, ELSEWHERE, drawing.width - ELSEWHERE, drawing.height - ELSEWHERE)
    outer = box.inset(*4 * (-BORDER,))
    drawing.line(box.corners, FRAME, closed=True)
    drawing.line(outer.corners, ZONES, closed=True)
    _zones(drawing, box, outer)
    _centring(drawing, box, outer)
    at = complex(box.right - 1.0, (box.bottom + outer.bottom) / 2 - BORDER)
    drawing.add(Words(at, titles.format.upper(), 3.5, 1 + 0j))
    block = Box(box.right - SIZE[0], box.bottom, box.right, box.bottom + SIZE[1])
    _block(drawing, block, titles)
    return box


def _zones(drawing: Drawing, box: Box, outer: Box) -> None:
    """Marks between zones, counted from the middle of the paper, with numbers along it and letters from the top."""
    middle = complex(drawing.width, drawing.height) / 2
    for half, low, high, across in (
        (middle.real, box.left, box.right, True),
        (middle.imag, box.bottom, box.top, False),
    ):
        count = 2 * round(half / ZONE)
        inner = [half + ZONE * k for k in range(1 - count // 2, count // 2)]
        ends = [low, *inner, high]
        for edge in inner:
            if not math.isclose(edge, half):  # there stands the centring mark
                _both(drawing, edge, across, box, outer)
        names = [str(k + 1) for k in range(count)] if across else LETTERS[:count][::-1]
        for name, (a, b) in zip(names, pairwise(ends), strict=True):
            at = (a + b) / 2
            sides = (outer.bottom + BORDER / 2, outer.top - BORDER / 2)
            if not across:
                sides = (outer.left + BORDER / 2, outer.right - BORDER / 2)
            for side in sides:
                drawing.add(Words(complex(at, side) if across else complex(side, at), name, 3.5))


def _both(drawing: Drawing, at: float, across: bool, box: Box, outer: Box) -> None:
    """A line through the border on both sides of the paper."""
    if across:
        drawing.line([complex(at, outer.bottom), complex(at, box.bottom)], ZONES)
        drawing.line([complex(at, box.top), complex(at, outer.top)], ZONES)
    else:
        drawing.line([complex(outer.left, at), complex(box.left, at)], ZONES)
        drawing.line([complex(box.right, at), complex(outer.right, at)], ZONES)


def _centring(drawing: Drawing, box: Box, outer: Box) -> None:
    """A mark in the middle of each side of the paper."""
    x, y = drawing.width / 2, drawing.height / 2
    drawing.line([complex(x, outer.bottom), complex(x, outer.bottom + MARK)], FRAME)
    drawing.line([complex(x, outer.top), complex(x, outer.top - MARK)], FRAME)
    drawing.line([complex(outer.left, y), complex(outer.left + MARK, y)], FRAME)
    drawing.line([complex(outer.right, y), complex(outer.right - MARK, y)], FRAME)


def _block(drawing: Drawing, block: Box, titles: Titles) -> None:
    """The fields that the standard asks for, each with its caption; a field is what is known of it."""
    who = titles.who
    drawing.line(block.corners, FRAME, closed=True)
    top, owner, middle, right = block.top, block.left, block.left + 60, block.left + 130
    number = f"{titles.number}/{titles.total}"
    fields = (
        (owner, top - ROW, 45, ROW, tr("Created by"), who.drawn_by),
        (owner + 45, top - ROW, 45, ROW, tr("Checked by"), who.checked_by),
        (owner + 90, top - ROW, 40, ROW, tr("Approved by"), who.approved_by),
        (right, top - ROW, 50, ROW, tr("Document type"), tr("Course project")),
        (owner, block.bottom, 60, 3 * ROW, tr("Legal owner"), who.organisation),
        (middle, block.bottom + ROW, 70, 2 * ROW, tr("Title"), titles.title),
        (middle, block.bottom, 70, ROW, tr("Supplementary title"), titles.name),
        (right, block.bottom + ROW, 50, 2 * ROW, tr("Identification number"), titles.designation),
        (right, block.bottom, 22, ROW, tr("Date of issue"), who.date),
        (right + 22, block.bottom, 12, ROW, tr("Lang."), spoken()),
        (right + 34, block.bottom, 16, ROW, tr("Sheet"), number),
    )
    for left, bottom, wide, high, said, text in fields:
        cell = Box(left, bottom, left + wide, bottom + high)
        drawing.line(cell.corners, BLOCK, closed=True)
        caption(drawing, Box(left, cell.top - 3.2, cell.right, cell.top), said, align=-1 + 0j, height=1.8)
        size, most = (5.0, 2) if high > ROW and text != titles.designation else (3.5, 1)
        filled_in(drawing, cell.inset(AIR / 2, 0, 0, 2.6), text, height=size, align=-1 + 0j, most=most)
