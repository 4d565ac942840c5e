"""Tables in a source of Typst: in letters in which they fit, beside each other, whole on a page where they can be."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import groupby

from tmmcalc.note.columns import Asked, least_width, measured, widths_of
from tmmcalc.note.tree import ACROSS, ALONG, CELL, POINT, Grid, Text, Written, numeric
from tmmcalc.note.typstwords import GAP, escaped, label, set_text
from tmmcalc.report.drawing.lettering import faces
from tmmcalc.report.formula.layout import Box, Digits, Fraction, Gap, Letter, Marked, Row, Script, Sign, Word, inner
from tmmcalc.report.language import tr

SMALL = (9.5, 9.0, 8.5, 8.0)  # sizes of tables [pt], the first in which one fits
WHOLE = (12, 34)  # rows: up to the first a table stands where it is told of, up to the second on one page
MOST = 40  # rows that a page has
CHAPTER = re.compile(r"\d+\.")  # what the number of a table in a numbered chapter begins with
PLAIN, SCRIPTED = 3.0, 3.6  # over and under the letters of a cell, of one with indices [pt]
CLOSE = 1e-3  # of the ends of a text to its column [mm]
INDEXED = 0.95  # height of letters with indices [em]


def beside(grids: Sequence[Grid]) -> bool:
    """Whether tables stand beside each other: alike long, and with room in letters that are not too small."""
    return len(set(map(_stands, grids))) == 1 and _size_of(grids, SMALL[:2]) > 0


def has_room(grid: Grid, wide: float) -> bool:
    """Whether a picture so wide [mm] stands beside a table, in letters of it that are not small, on one page."""
    return _stands(grid) == "whole" and _width_at(grid, SMALL[0]) + GAP + wide <= ACROSS


def set_pictured(grid: Grid, picture: str, wide: float, *, stays: bool) -> str:
    """A table with a picture at its right hand."""
    own = ACROSS - GAP - wide
    return _floated(grid, f"stood(({own:g}mm, {wide:g}mm), {_grid(grid, SMALL[0], own)}, {picture})", stays=stays)


def floating(group: Sequence[Written], *, waits: bool) -> bool:
    """Whether tables go where there is room: long ones, with a picture, or where another one ``waits`` before them."""
    grids = [each for each in group if isinstance(each, Grid)]
    stands = _stands(grids[0])
    if len(grids) < len(group) or stands == "whole":
        return True
    numbered = CHAPTER.match(grids[0].caption.number)
    rows = max(len(each.rows) for each in grids)
    return waits and numbered is not None and rows <= MOST and _size_of(grids, SMALL) > 0


def set_tables(grids: Sequence[Grid], *, floats: bool, stays: bool) -> str:
    """Tables beside each other, or one, in letters as small as they need; one that ``stays`` floats no more.

    A short table stands where it is told of, a longer one whole where there is room, one of many rows over pages; one
    that is too wide in small letters stands turned on a page of its own.
    """
    size = _size_of(grids, SMALL)
    if not size:
        return f"#turned[#{_grid(grids[0], _size_of(grids[:1], SMALL, ALONG) or SMALL[-1], ALONG)}]"
    free = (ACROSS - GAP * (len(grids) - 1) - sum(_width_at(each, size) for each in grids)) / len(grids)
    shares = [_width_at(each, size) + free for each in grids]
    tables = [_grid(each, size, wide) for each, wide in zip(grids, shares, strict=True)]
    stood = f"stood(({', '.join(f'{wide:g}mm' for wide in shares)}), {', '.join(tables)})" if tables[1:] else tables[0]
    return _floated(grids[0], stood, stays=stays) if floats else f"#{stood}"


def _floated(first: Grid, stood: str, *, stays: bool) -> str:
    return f"#floated({label('tab', first.caption)}, {str(stays).lower()}, {stood})"


def _stands(grid: Grid) -> str:
    """Where a table stands by the number of its rows."""
    rows = len(grid.rows)
    if rows <= WHOLE[0]:
        return "here"
    floats = rows <= WHOLE[1] and CHAPTER.match(grid.caption.number) is not None
    return "whole" if floats and _size_of([grid], SMALL) else "on"


def _size_of(grids: Sequence[Grid], sizes: Sequence[float], wide: float = ACROSS) -> float:
    """The size of letters [pt] in which tables have room beside each other, on so much [mm], or 0."""
    room = wide - GAP * (len(grids) - 1)
    return next((size for size in sizes if sum(_width_at(each, size) for each in grids) <= room), 0.0)


def _width_at(grid: Grid, size: float) -> float:
    """How wide a table is at least, in letters of this size [mm]."""
    return least_width(grid, size * POINT, CELL)


def _grid(grid: Grid, size: float, wide: float) -> str:
    """A table in letters of a size, no wider than so much [mm].

    Where the height of a row is known it is told: Typst needs half of its time for heights of rows that it looks for.
    """
    caption = grid.caption
    widths = widths_of(grid, size * POINT, CELL, wide)
    heights = [_height(*row, size, widths) for row in zip(grid.rows, measured(grid)[1:], strict=True)]
    heads = "".join(_cell(cell, "center + horizon") for cell in grid.head)
    rows = zip(grid.rows, heights, strict=True)
    cells = "".join(f"[{set_text(cell)}], " if high else _cell(cell) for row, high in rows for cell in row)
    columns = zip(*grid.rows, strict=True)
    aligned = "".join("right + horizon, " if numeric(column) else "left + horizon, " for column in columns)
    continued = tr("Continuation of table {number}", number=caption.number)
    said = f"[{set_text(caption.whole)}], [{escaped(continued)}]"
    breaks = _stands(grid) == "on"
    across = "".join(f"{each:.3f}mm, " for each in widths)
    down = "".join(
        f" + ({f'{high:.4g}pt' if high else 'auto'},) * {len(list(alike))}" for high, alike in groupby(heights)
    )
    laid = f"({across}), ({'auto, ' * (1 + breaks)}){down}, ({aligned}), {size}pt, {wide:g}mm, {str(breaks).lower()}"
    return f"listed({label('tab', caption)}, {said}, {laid}, ({heads}), ({cells}))"


def _height(row: Sequence[Text], asked: Sequence[Asked], size: float, widths: Sequence[float]) -> float:
    """Height of a row of which each cell is one line of letters [pt], or 0."""
    if any(text.whole * size * POINT + CELL > wide + CLOSE for text, wide in zip(asked, widths, strict=True)):
        return 0.0
    boxes = [part for cell in row for part in cell.parts if isinstance(part, Row)]
    if not all(map(_level, boxes)):
        return 0.0
    capital = faces()["regular"]["capital"]
    return (INDEXED if any(map(_scripted, boxes)) else capital) * size + 2 * PLAIN


def _level(box: Box) -> bool:
    """Whether it is letters on a line, with indices that have none of their own."""
    if isinstance(box, Script):
        return not any(map(_scripted, inner(box))) and all(map(_level, inner(box)))
    return isinstance(box, Letter | Word | Digits | Sign | Gap | Row | Marked) and all(map(_level, inner(box)))


def _cell(cell: Text, align: str = "") -> str:
    """A cell as high as it is, with room for indices."""
    said = [f"align: {align}"] if align else []
    if any(isinstance(part, Row) and _scripted(part) for part in cell.parts):
        said.append(f"inset: (x: 3pt, y: {SCRIPTED:g}pt)")
    return f"table.cell({', '.join(said)})[{set_text(cell)}], " if said else f"[{set_text(cell)}], "


def _scripted(box: Box) -> bool:
    return isinstance(box, Script | Fraction) or any(map(_scripted, inner(box)))
