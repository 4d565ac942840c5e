"""A sheet cut into pages of A4 for a printer at home, in true size: they overlap, have marks to cut at, and names."""

from __future__ import annotations

import math
from io import BytesIO
from itertools import product
from typing import NamedTuple

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pdf import POINT, begun, draw_on
from tmmcalc.report.drawing.pens import BLOCK
from tmmcalc.report.drawing.reach import reach
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr

A4 = (210.0, 297.0)  # [mm]
MARGIN = 10.0  # that printers leave free [mm]
OVERLAP = 10.0  # of neighbouring pages [mm]
MARK = 5.0  # length of a mark where a page is cut [mm]


class Tile(NamedTuple):
    """A page: its row from the top and its column, from 1, and the part of the sheet that it shows."""

    row: int
    column: int
    part: Box


def tiles(width: float, height: float) -> tuple[tuple[float, float], list[Tile]]:
    """The page, upright or across, whichever needs fewer pages; the pages of a sheet, from its upper left corner."""
    ways = []
    for page in (A4, A4[::-1]):
        step = page[0] - 2 * MARGIN - OVERLAP, page[1] - 2 * MARGIN - OVERLAP
        columns, rows = math.ceil((width - OVERLAP) / step[0]), math.ceil((height - OVERLAP) / step[1])
        ways.append((columns * rows, page, columns, rows, step))
    _, page, columns, rows, step = min(ways, key=lambda way: way[0])
    found = []
    for row, column in product(range(rows), range(columns)):
        left, top = column * step[0], height - row * step[1]
        part = Box(left, max(top - step[1] - OVERLAP, 0.0), min(left + step[0] + OVERLAP, width), top)
        found.append(Tile(row + 1, column + 1, part))
    return page, found


def tiled(drawing: Drawing, name: str) -> bytes:
    """The pages as a PDF; ``name`` is that of the sheet."""
    page, parts = tiles(drawing.width, drawing.height)
    shapes = [(shape, reach(shape).inset(*4 * (-1.0,))) for shape in drawing.shapes]  # with the width of lines
    buffer = BytesIO()
    canvas = begun(buffer, drawing, *page)
    for tile in parts:
        shown = Box(MARGIN, page[1] - MARGIN - tile.part.height, MARGIN + tile.part.width, page[1] - MARGIN)
        canvas.saveState()
        path = canvas.beginPath()
        path.rect(*(size * POINT for size in (shown.left, shown.bottom, shown.width, shown.height)))
        canvas.clipPath(path, stroke=0, fill=0)
        canvas.translate((shown.left - tile.part.left) * POINT, (shown.bottom - tile.part.bottom) * POINT)
        draw_on(canvas, [shape for shape, box in shapes if _meet(box, tile.part)])
        canvas.restoreState()
        canvas.saveState()
        draw_on(canvas, _marks(page, shown, tile, name, len(parts)).shapes)
        canvas.restoreState()
        canvas.showPage()
    canvas.save()
    return buffer.getvalue()


def _meet(one: Box, other: Box) -> bool:
    across = one.left < other.right and other.left < one.right
    return across and one.bottom < other.top and other.bottom < one.top


def _marks(page: tuple[float, float], shown: Box, tile: Tile, name: str, count: int) -> Drawing:
    """Where a page is cut, and what it is called."""
    drawing = Drawing(*page)
    for x in (shown.left, shown.right):
        drawing.line([complex(x, shown.top + 1), complex(x, shown.top + MARK)], BLOCK)
        drawing.line([complex(x, shown.bottom - 1), complex(x, shown.bottom - MARK)], BLOCK)
    for y in (shown.bottom, shown.top):
        drawing.line([complex(shown.left - 1, y), complex(shown.left - MARK, y)], BLOCK)
        drawing.line([complex(shown.right + 1, y), complex(shown.right + MARK, y)], BLOCK)
    said = tr(
        "{name}: row {row}, column {column}; {count} pages that overlap by {overlap} mm",
        name=name,
        row=tile.row,
        column=tile.column,
        count=count,
        overlap=f"{OVERLAP:g}",
    )
    drawing.add(Words(complex(shown.middle.real, shown.top + 3.5), said, 2.5))
    return drawing
