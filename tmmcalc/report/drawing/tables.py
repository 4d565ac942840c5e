"""A ruled table on paper: as high as its rows, in as many blocks side by side as it needs."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import MIDDLE, THIN
from tmmcalc.report.drawing.shapes import Drawing, Words

PITCH = 2.05  # height of a row, of the height of its letters
AIR = 1.1  # beside the words of a cell, of the same
GAP = 2.5  # between blocks [mm]
SMALLER = 0.96  # from one try to the next


def draw_table(
    drawing: Drawing, box: Box, head: Sequence[str], rows: Sequence[Sequence[str]], height: float = 2.3
) -> float:
    """Write a table from the upper left corner of a rectangle, smaller where it has no room; returns its height [mm].

    Cells are texts; the first column stands on the left of its cells, the others in the middle.
    """
    if not rows:
        return 0.0
    widths = [max(width(cell) for cell in column) for column in zip(head, *rows, strict=True)]
    count = _blocks(box, widths, len(rows), height)
    while sum(_wide(widths, height)) * count + GAP * (count - 1) > box.width:
        height *= SMALLER
        count = _blocks(box, widths, len(rows), height)
    each = ceil(len(rows) / count)
    sizes = _wide(widths, height)
    for k in range(count):
        left = box.left + k * (sum(sizes) + GAP)
        _block(drawing, complex(left, box.top), sizes, [head, *rows[k * each : (k + 1) * each]], height)
    return (each + 1) * PITCH * height


def _blocks(box: Box, widths: Sequence[float], rows: int, height: float) -> int:
    """How many blocks the height of the rectangle asks for."""
    return ceil(rows / max(1, int(box.height / (PITCH * height) + 1e-9) - 1))


def _wide(widths: Sequence[float], height: float) -> list[float]:
    return [(wide + 2 * AIR) * height for wide in widths]


def _block(
    drawing: Drawing, corner: complex, sizes: Sequence[float], rows: Sequence[Sequence[str]], height: float
) -> None:
    pitch, wide = PITCH * height, sum(sizes)
    for k in range(len(rows) + 1):
        drawing.line([corner - 1j * k * pitch, corner - 1j * k * pitch + wide], MIDDLE if k < 2 else THIN)
    edges = [sum(sizes[:k]) for k in range(len(sizes) + 1)]
    for edge in edges:
        drawing.line([corner + edge, corner + edge - 1j * len(rows) * pitch], THIN)
    for r, row in enumerate(rows):
        for c, cell in enumerate(row):
            left = c == 0 and r > 0
            at = edges[c] + (AIR * height if left else sizes[c] / 2) - 1j * (r + 0.5) * pitch
            drawing.add(Words(corner + at, cell, height, -1 if left else 0j))
