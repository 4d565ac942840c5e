"""A drawing of sheets under one another, each with its title."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing, Words

HEADING = 7.0  # room of a title [mm]
Sheet = tuple[str, Callable[[Drawing, Box], object]]  # title, and what draws it


def sheets_of(content: Sequence[Sheet]) -> Drawing:
    """The sheets, drawn."""
    drawing, boxes = sheets(len(content))
    for box, (title, draw) in zip(boxes, content, strict=True):
        drawing.add(Words(complex(box.middle.real, box.top), title, 3.5, 1j))
        draw(drawing, box.inset(0, 0, 0, HEADING))
    return drawing
