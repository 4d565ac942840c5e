"""The page of a picture: sheets of one size, A4 landscape or that in force, one under another, so that scales hold."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, NamedTuple

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.lettering import width as width_of
from tmmcalc.report.drawing.shapes import Drawing, Words

BORDER = 7.0  # free on all sides [mm]
HEIGHT = 2.5  # of the letters of the project's title, in the border above [mm]


class Paper(NamedTuple):
    """What pictures are drawn on."""

    width: float = 297.0  # [mm]
    height: float = 210.0
    project: str = ""  # what the work is called


A4 = Paper()
_paper: ContextVar[Paper] = ContextVar("paper", default=A4)


@contextmanager
def on_paper(**changes: Any) -> Iterator[None]:
    """Pictures that are drawn within stand on this paper; fields of `Paper` that are not named stay as they are."""
    token = _paper.set(_paper.get()._replace(**changes))
    try:
        yield
    finally:
        _paper.reset(token)


def sheets(count: int, title: str = "") -> tuple[Drawing, list[Box]]:
    """An empty drawing of so many sheets, and the free rectangle of each, the first on top."""
    wide, high, project = _paper.get()
    drawing = Drawing(wide, count * high, title)
    if project:
        said = plain(project)
        size = HEIGHT * min(1.0, (wide - 2 * BORDER) / width_of(said, HEIGHT))
        drawing.add(Words(complex(BORDER, drawing.height - BORDER / 2), said, size, -1 + 0j))
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
