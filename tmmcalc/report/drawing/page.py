"""The page of a picture: sheets of A4 landscape, one under another, so that scales hold on paper."""

from __future__ import annotations

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import width as width_of
from tmmcalc.report.drawing.shapes import Drawing, Words

A4 = (297.0, 210.0)  # [mm]
BORDER = 7.0  # free on all sides [mm]


def sheets(count: int, title: str = "") -> tuple[Drawing, list[Box]]:
    """An empty drawing of so many sheets, and the free rectangle of each, the first on top."""
    wide, high = A4
    drawing = Drawing(wide, count * high, title)
    boxes = [Box(0.0, k * high, wide, (k + 1) * high).inset(*4 * (BORDER,)) for k in range(count)]
    return drawing, boxes[::-1]


def titled(title: str, height: float = 3.5) -> tuple[Drawing, Box]:
    """One sheet with a title of one or several lines on top, smaller if too wide, and the free rectangle under it."""
    drawing, (box,) = sheets(1)
    return drawing, headed(drawing, box, title, height)


def headed(drawing: Drawing, box: Box, title: str, height: float = 3.5) -> Box:
    """Write a title on top of a rectangle, smaller where it is too long; what is free under it."""
    size = height * min(1.0, box.width / width_of(title, height))
    drawing.add(Words(complex(box.middle.real, box.top), title, size, 1j))
    return box.inset(0, 0, 0, height * (1.3 + 1.75 * title.count("\n")) + 2.5)
