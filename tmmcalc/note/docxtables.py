"""Tables of a document of Word: in letters in which they fit, no wider than they need, or turned."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.note.columns import least_width
from tmmcalc.note.tree import POINT, Grid

CELLS = (12, 11, 10, 9, 8)  # sizes of tables [pt], the first in which one fits; one that does not stands turned
WHOLE = 15  # rows: a table of up to so many stands on one page
MARGIN = 68  # between a text and a line; so far a table stands in, for its lines to keep the margin [twips]
PADDING = 3.0  # of a column between its texts and lines [mm]
TWIPS = 1440 / 25.4  # to a mm


def table(widths: Sequence[float], rows: Sequence[tuple[str, Sequence[str]]], style: str = "") -> str:
    """A table of columns so wide [mm]; rows are what is said of them, and cells of paragraphs.

    Without a style there are no lines, and nothing is kept free beside the texts.
    """
    dxa = [round(size * TWIPS) for size in widths]
    grid = "".join(f'<w:gridCol w:w="{size}"/>' for size in dxa)
    said = []
    for properties, cells in rows:
        each = (
            f'<w:tc><w:tcPr><w:tcW w:w="{size}" w:type="dxa"/><w:vAlign w:val="center"/></w:tcPr>{cell}</w:tc>'
            for size, cell in zip(dxa, cells, strict=True)
        )
        said.append(f"<w:tr><w:trPr><w:cantSplit/>{properties}</w:trPr>{''.join(each)}</w:tr>")
    styled = f'<w:tblStyle w:val="{style}"/>' if style else ""
    free = MARGIN if style else 0
    sized = f'<w:tblW w:w="{sum(dxa)}" w:type="dxa"/><w:tblInd w:w="{free}" w:type="dxa"/><w:tblLayout w:type="fixed"/>'
    beside = "".join(f'<w:{side} w:w="{free}" w:type="dxa"/>' for side in ("left", "right"))
    told = f"{styled}{sized}<w:tblCellMar>{beside}</w:tblCellMar>"
    return f"<w:tbl><w:tblPr>{told}</w:tblPr><w:tblGrid>{grid}</w:tblGrid>{''.join(said)}</w:tbl>"


def size_of(grid: Grid, room: float) -> int | None:
    """The size of letters [pt] in which a table fits so much room [mm], if there is one."""
    return next((size for size in CELLS if least_width(grid, size * POINT, PADDING) <= room), None)
