"""Small tables beside a drawing: rows of texts in columns, with thin lines under headings."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from tmmcalc.report.drawing.labels import MM
from tmmcalc.report.drawing.style import INK, THIN

ROW = 4.3  # height of a row [mm]
SIZE = 7.5  # of the texts
GREY = "#555555"


class Heading(tuple[str, ...]):
    """A row over a thin line."""

    __slots__ = ()


Row = Sequence[str]  # a text at the left, then a text for every column


def list_rows(axes: Axes, rows: Sequence[Row], columns: Sequence[float]) -> None:
    """Write rows from the top of an axes whose place is settled; ``columns`` are their right ends [mm].

    The first column begins at the left. Rows draw nearer to each other where there is too little room.
    """
    axes.set_axis_off()
    box, dpi = axes.get_window_extent(), axes.figure.dpi
    width, height = box.width * MM / dpi, box.height * MM / dpi
    axes.set_xlim(0, width)
    axes.set_ylim(-height, 0)
    step = min(ROW, height / (len(rows) + 0.5))
    size = SIZE * min(1.0, 1.15 * step / ROW)
    for k, row in enumerate(rows):
        y = -(k + 0.5) * step
        color = GREY if isinstance(row, Heading) else INK
        if isinstance(row, Heading):
            axes.plot([0, width], [y - 0.5 * step] * 2, color=THIN, linewidth=0.5)
        for x, side, text in zip((0.0, *columns), ("left", *("right" for _ in columns)), row, strict=False):
            axes.text(x, y, text, va="center", ha=side, size=size, color=color)
