"""The names of the phases in a row along the top of a diagram over the turn, and the lines at which phases end."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.wording import phase_name
from tmmcalc.cams.program import PhaseKind
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Words
from tmmcalc.report.numbers import number

SIZE, BETWEEN = 2.2, 2.5  # of the names; least between two of them [mm]
AIR = 1.0  # above the names and below them [mm]
PITCH = 1.8  # of lines of a name, in heights of its letters


class PhaseRow(NamedTuple):
    """Names with their middles from the left edge of the diagram [mm]; the angles at which phases end [deg]."""

    names: tuple[str, ...]
    middles: tuple[float, ...]
    ends: Values  # (n + 1,)
    height: float  # with the air around it [mm]


def phase_row(kinds: Sequence[PhaseKind], ends: Values, room: float, *, angles: bool = True) -> PhaseRow:
    """The row over a diagram as wide as ``room`` [mm]; a name that is wider than its phase has a line for each word."""
    scale = room / float(ends[-1])
    names = []
    for kind, span in zip(kinds, np.diff(ends).tolist(), strict=True):
        name = phase_name(kind)
        if width(name, SIZE) + BETWEEN > span * scale:
            name = name.replace(" ", "\n")
        names.append(f"{name}\n{number(span, 5)}°" if angles else name)
    halves = [width(name, SIZE) / 2 for name in names]
    middles = (scale * (ends[:-1] + ends[1:]) / 2).tolist()
    lines = max(name.count("\n") for name in names)
    height = (1.0 + lines * PITCH) * SIZE + 2 * AIR
    return PhaseRow(tuple(names), tuple(spread(middles, halves, room)), ends, height)


def draw_phases(diagram: Diagram, row: PhaseRow, pen: Pen) -> None:
    """The names, and lines at which phases end: one that would cross a name ends below the row."""
    line_phases(diagram, row.ends, pen, row.height)
    box = diagram.box
    taken = []
    for name, middle in zip(row.names, row.middles, strict=True):
        at, half = box.left + middle, width(name, SIZE) / 2
        taken.append((at - half - AIR / 2, at + half + AIR / 2))
        diagram.drawing.add(Words(complex(at, box.top - AIR), name, SIZE, 1j), level=5)
    for end in row.ends[1:-1].tolist():
        at = diagram.place(complex(end)).real
        if all(not low < at < high for low, high in taken):
            diagram.drawing.line([complex(at, box.top - row.height), complex(at, box.top)], pen, level=1)


def line_phases(diagram: Diagram, ends: Values, pen: Pen, below: float = 0.0) -> None:
    """Lines at the ends of phases [deg] up to ``below`` mm under the top of a diagram."""
    box = diagram.box
    for end in ends[1:-1].tolist():
        at = diagram.place(complex(end)).real
        line = [complex(at, box.bottom), complex(at, box.top - below)]
        diagram.drawing.line(line, pen, level=1)
        diagram.labels.avoid(line, 0.5)


def spread(middles: Sequence[float], halves: Sequence[float], end: float) -> list[float]:
    """Middles of texts in a row from 0 to ``end`` [mm], moved as little to the sides as keeps them apart.

    >>> spread([2.0, 3.0, 50.0], [4.0, 4.0, 10.0], 60.0)
    [4.0, 14.5, 50.0]
    """
    found, free = [], 0.0
    for middle, half in zip(middles, halves, strict=True):
        found.append(max(middle, free + half))
        free = found[-1] + half + BETWEEN
    free = end
    for k in reversed(range(len(found))):
        found[k] = min(found[k], free - halves[k])
        free = found[k] - halves[k] - BETWEEN
    return found
