"""A table cut to a width: what the terminal and plain text share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from tmmcalc.report.document import Document
from tmmcalc.report.numbers import column

GAP = 2  # spaces between columns


class Cells(NamedTuple):
    """A column ready to print: name, unit, cells, and whether it is text (left) or numbers (right)."""

    name: str
    unit: str
    cells: list[str]
    text: bool

    @property
    def width(self) -> int:
        """Characters of the widest cell."""
        return max(map(len, (self.name, self.unit, *self.cells)))


def fitted(document: Document, width: int) -> tuple[list[Cells], int]:
    """The columns of the table that fit the width (all, unless it is wide), and how many were cut."""
    if document.table is None:
        return [], 0
    kept: list[Cells] = []
    used = 0
    total = len(document.table.headers)
    for header, values in zip(document.table.headers, document.table.columns, strict=True):
        name, _, unit = header.partition("[")
        cells = Cells(name, unit.removesuffix("]"), *_cells(values))
        used += cells.width + GAP
        if document.wide and used > width and len(kept) >= 2:
            break
        kept.append(cells)
    return kept, total - len(kept)


def _cells(values: Sequence[Any]) -> tuple[list[str], bool]:
    text = any(isinstance(v, str) for v in values)
    if text or all(isinstance(v, int) for v in values):
        return [str(v) for v in values], text
    return column(values), False
