"""Small tables beside a drawing: rows of texts in columns, with thin lines under headings."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import extent, width
from tmmcalc.report.drawing.pens import INK, THIN
from tmmcalc.report.drawing.shapes import Drawing, Words

ROW = 4.8  # height of a row [mm]
HEIGHT = 2.2  # of the texts
AIR = 1.5  # least room between texts of a row
GREY = "#555555"


class Heading(tuple[str, ...]):
    """A row over a thin line."""

    __slots__ = ()


Row = Sequence[str]  # a text at the left, then a text for every column


def list_rows(drawing: Drawing, box: Box, rows: Sequence[Row], columns: Sequence[float]) -> float:
    """Write rows from the top of a rectangle; ``columns`` are their right ends [mm]. The height where they end.

    The first column begins at the left. Rows draw nearer to each other where there is too little room, texts of a row
    that would touch are smaller.
    """
    step = min(ROW, box.height / (len(rows) + 0.5 * sum(isinstance(row, Heading) for row in rows)))
    y = box.top
    for row in rows:
        heading = isinstance(row, Heading)
        y -= step * (1.5 if heading and row is not rows[0] else 1.0)
        fitting = _fitting(row, columns) if len(row) > 1 else box.width / max(width("".join(row), HEIGHT), 1.0)
        height = HEIGHT * min(1.0, 1.15 * step / ROW, fitting)
        baseline = y + (step - height) / 2
        if heading:
            drawing.line([complex(box.left, y), complex(box.right, y)], THIN)
        for k, text in enumerate(row):
            at = box.left if k == 0 else box.left + columns[k - 1]
            above, below = extent(text, height)
            middle = baseline + (above - below) / 2  # texts of a row stand on one line
            drawing.add(Words(complex(at, middle), text, height, 1 if k else -1, colour=GREY if heading else INK))
    return y


def _fitting(row: Row, columns: Sequence[float]) -> float:
    """The part of their height at which the texts of a row keep apart."""
    part, last = 1.0, 0.0
    before = ""
    for k, text in enumerate(row):
        if text and before:
            room = columns[k - 1] - last - AIR
            used = width(text, HEIGHT) + (width(before, HEIGHT) if last == 0.0 else 0.0)
            part = min(part, room / used)
        if text:
            before, last = text, columns[k - 1] if k else 0.0
    return part
