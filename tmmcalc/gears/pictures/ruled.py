"""Tables with lines on a drawing: a frame, a head, columns as wide as their longest text."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import extent, width
from tmmcalc.report.drawing.pens import MIDDLE, THIN
from tmmcalc.report.drawing.shapes import Drawing, Words

ROW, HEIGHT = 2.0, 2.5  # from row to row in heights of the letters, and that height at most [mm]
AIR = 1.6  # beside the texts of a cell, in heights of the letters


def ruled_table(
    drawing: Drawing, box: Box, head: Sequence[str], rows: Sequence[Sequence[str]], *, most: float = HEIGHT
) -> float:
    """Write a table from the top left of a rectangle; the height where it ends.

    Texts of the first column begin at its left, the others stand in the middle. ``most`` is the height of letters [mm]
    where there is room; they are smaller where the rectangle is.
    """
    every = [head, *rows]
    widths = [max(width(row[k]) for row in every) + AIR for k in range(len(head))]
    size = min(most, box.width / sum(widths), box.height / (ROW * len(every)))
    edges = [box.left]
    for each in widths:
        edges.append(edges[-1] + each * size)
    step = ROW * size
    bottom = box.top - step * len(every)
    for number, row in enumerate(every):
        middle = box.top - (number + 0.5) * step
        for k, text in enumerate(row):
            at = edges[k] + AIR * size / 2 if k == 0 else (edges[k] + edges[k + 1]) / 2
            above, below = extent(text, size) if text else (0.0, 0.0)
            # capitals of a row stand on one line
            place = complex(at, middle - size / 2 + (above - below) / 2)
            drawing.add(Words(place, text, size, 0 if k else -1))
    for number in range(len(every) + 1):
        y = box.top - number * step
        pen = MIDDLE if number in (0, 1, len(every)) else THIN
        drawing.line([complex(edges[0], y), complex(edges[-1], y)], pen)
    for k, x in enumerate(edges):
        pen = MIDDLE if k in (0, len(edges) - 1) else THIN
        drawing.line([complex(x, box.top), complex(x, bottom)], pen)
    return bottom
