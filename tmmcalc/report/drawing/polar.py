"""Hodographs on a board: named axes with round numbers through the origin, positions along a path."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.curves import DOTTED, suited
from tmmcalc.report.drawing.diagram import DOT, HEIGHT, Axis, ticks, written
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import GRID, MIDDLE, THIN, Pen
from tmmcalc.report.drawing.shapes import Arc, Words

AROUND = (14.0, 9.0, 1.0)  # room for numbers and names: left, bottom, right [mm]
APART = 5.0  # positions nearer than this to a numbered one go without a number [mm]
STEP = 11.0  # least distance of lines of the grid [mm]


def name_axes(board: Board, names: tuple[str, str], peak: float, unit: str) -> None:
    """Frame, names, grid and ticks of a hodograph of values as large as ``peak``, which is drawn in SI."""
    factor, shown = suited(peak, unit)
    box, draw = board.box, board.drawing
    low, high = board.data(complex(box.left, box.bottom)), board.data(complex(box.right, box.top))
    across = Axis(names[0], low.real * factor, high.real * factor)
    up = Axis(names[1], low.imag * factor, high.imag * factor)
    for along, axis in ((1.0, across), (1j, up)):
        most = max(2, int((box.width if along == 1 else box.height) / STEP))
        values = ticks(axis, most)
        for value in values:
            at = board.place(value / factor * along)
            pen = MIDDLE if value == 0 else GRID
            if along == 1:
                draw.line([complex(at.real, box.bottom), complex(at.real, box.top)], pen, level=-1)
                draw.add(Words(complex(at.real, box.bottom - 1.2), written(value, values), 2.0, 1j))
            else:
                draw.line([complex(box.left, at.imag), complex(box.right, at.imag)], pen, level=-1)
                draw.add(Words(complex(box.left - 1.2, at.imag), written(value, values), 2.0, 1))
    corners = [complex(box.left, box.bottom), complex(box.right, box.bottom)]
    draw.line([*corners, complex(box.right, box.top), complex(box.left, box.top)], THIN, closed=True, level=-1)
    draw.add(Words(complex(box.middle.real, box.bottom - 4.5), f"${names[0]}$, {shown}", HEIGHT, 1j))
    draw.add(Words(complex(box.left - 10.0, box.middle.imag), f"${names[1]}$, {shown}", HEIGHT, -1j, np.pi / 2))


def number_tips(board: Board, labels: Sequence[str], tips: Plane, pen: Pen) -> None:
    """Positions as dots, some of them numbered where there is room; none of too many."""
    if not 0 < len(labels) <= DOTTED:
        return
    fine = pen._replace(width=0.13, dashes=())
    numbered: list[complex] = []
    for label, tip in zip(labels, tips.tolist(), strict=True):
        board.drawing.add(Arc(board.place(tip), DOT, fine, fill=pen.colour), level=8)
        if all(abs(tip - other) > APART * board.mu for other in [0j, *numbered]):
            numbered.append(tip)
            at, gaps = board.paper([tip]), (0.7, 1.3, 2.1)
            board.labels.put(label, at, height=1.5, prefer=tip or 1, gaps=gaps, colour=pen.colour)
