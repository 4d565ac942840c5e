"""Pictures to scale at the width of the note: as high as what is drawn, from the top of the most that they may be."""

from __future__ import annotations

from collections.abc import Callable

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.reach import moved, reach
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.manuscript import Figure
from tmmcalc.report.telling import WIDE

AIR = 1.0  # under the lowest thing drawn [mm]


def hung(caption: str, draw: Callable[[Drawing, Box], object], high: float, key: str) -> Figure:
    """The picture without what it leaves free of ``high`` below; a drawing to a standard scale seldom fills it."""
    trial = Drawing(WIDE, high)
    draw(trial, Box(0.0, 0.0, WIDE, high))
    free = max(min(reach(shape).bottom for shape in trial.shapes) - AIR, 0.0)

    shapes = [moved(shape, -1j * free) for shape in trial.shapes]
    return Figure(caption, lambda drawing, _: drawing.add(*shapes), (WIDE, high - free), key)
