"""Diagrams over a plain variable, one under another: curves with their names above, marked places and levels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import fitted
from tmmcalc.report.drawing.diagram import Axis, Diagram, key_rows, room
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing

PLACE = Pen("PLACES", 0.2, (1.6, 1.2), "#8a8a8a")
MOST = 6000  # points of a curve that are drawn


@record
class Panel:
    """Curves of one quantity with their names; ``first`` is the number of the first pen."""

    label: str
    lines: tuple[tuple[str, Real], ...]
    first: int = 0
    log: bool = False
    ends: tuple[float, float] | None = None  # of the ordinate; None: all values and zero, with air

    @property
    def named(self) -> list[tuple[str, Pen]]:
        """The names of its curves with their pens."""
        return [(name, CURVES[(self.first + k) % len(CURVES)]) for k, (name, _) in enumerate(self.lines)]

    @property
    def axis(self) -> Axis:
        """The ordinate."""
        values = [line for _, line in self.lines]
        return Axis(self.label, *(room(values) if self.ends is None else self.ends), log=self.log)


def panels(
    drawing: Drawing, box: Box, x: Real, abscissa: Axis | str, rows: Sequence[Panel], heights: Sequence[float] = ()
) -> list[Diagram]:
    """Diagrams over ``x`` (n,), in these proportions; the numbers of the abscissa stand under the lowest."""
    along = Axis(abscissa, float(np.min(x)), float(np.max(x))) if isinstance(abscissa, str) else abscissa
    if along.low == along.high:
        along = along._replace(high=along.low + 1.0)
    larger = drawing.letters

    def above(wide: float) -> list[int]:
        return [len(key_rows(row.named, wide, larger)) for row in rows]

    frames = fitted(box, above, lambda _: [row.axis for row in rows], heights, larger)
    found = []
    for k, (row, frame) in enumerate(zip(rows, frames, strict=True)):
        diagram = Diagram(drawing, frame, along, row.axis, numbered=k + 1 == len(rows))
        for (_, values), (_, pen) in zip(row.lines, row.named, strict=True):
            draw_thinned(diagram, x, values, pen, row.log)
        diagram.key(row.named)
        found.append(diagram)
    return found


def draw_thinned(diagram: Diagram, x: Real, values: Real, pen: Pen, log: bool = False) -> None:
    """A curve of not more points than are seen; on a logarithmic axis what is not above zero lies at its end."""
    step = slice(None, None, max(1, int(np.ceil(len(values) / MOST))))
    y = np.maximum(values[step], diagram.y.low) if log else values[step]
    diagram.curve(x[step] + 1j * y, pen)


def marked(diagrams: Iterable[Diagram], places: Iterable[float]) -> None:
    """Thin lines at places along x that lie within."""
    every = list(places)
    for diagram in diagrams:
        for place in every:
            diagram.vertical(place, PLACE)
