"""The height that a picture to scale needs: a standard scale leaves room that stays white."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.reach import around, reach
from tmmcalc.report.drawing.shapes import Drawing

FREE = 10.0  # that a board keeps above and below what is drawn on it [mm]; more than its margin


def snug(draw: Callable[[Drawing, Box], object], size: tuple[float, float]) -> tuple[float, float]:
    """The size [mm] of a picture without what its boards, one beside another, leave free above and below.

    Their scales stay, for the content keeps its margin. A picture with a diagram, or with boards one above another, has
    its whole size.
    """
    drawing = Drawing(*size, "")
    draw(drawing, Box(0.0, 0.0, *size))
    boards = drawing.fields
    if not boards or not all(isinstance(field, Board) for field in boards):
        return size
    if any(abs(field.box.bottom - boards[0].box.bottom) > FREE for field in boards):
        return size
    boxes = [*map(reach, drawing.shapes)]
    free = min(_free(field.box, boxes) for field in boards)
    return size[0], size[1] - max(0.0, free - 2 * FREE)


def _free(frame: Box, boxes: Iterable[Box]) -> float:
    """The height of a frame less that of what lies in it [mm]."""
    within = [
        each
        for each in boxes
        if frame.left <= each.middle.real <= frame.right and frame.bottom <= each.middle.imag <= frame.top
    ]
    return frame.height - (around(within).height if within else frame.height)
