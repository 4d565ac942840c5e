"""A table cut to a width: what the terminal and plain text share."""

from __future__ import annotations

from typing import Any, NamedTuple

from tmmcalc.core.headers import key_and_unit
from tmmcalc.report.document import Document, View
from tmmcalc.report.numbers import column, scientific

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
    view = document.table
    if view is None:
        return [], 0
    kept: list[Cells] = []
    used = -GAP
    for k, header in enumerate(view.headers):
        cells = Cells(*key_and_unit(header), *_cells(view, k))
        used += GAP + cells.width
        if document.wide and used > width and len(kept) >= 2:
            break
        kept.append(cells)
    return kept, len(view.headers) - len(kept)


def _cells(view: View, k: int) -> tuple[list[str], bool]:
    """Cells of column k, and whether they are text; a word in place of a number stands among the numbers."""
    values = [yes_or_no(v) for v in view.columns[k]]
    numbers = [v for v in values if not isinstance(v, str)]
    if not numbers or all(isinstance(v, int) for v in numbers):
        return [str(v) for v in values], len(numbers) < len(values)
    if view.headers[k] in view.scientific:
        cells = iter(scientific(numbers))
    else:
        cells = iter(column(numbers, view.peaks[k] if view.peaks else 0.0))
    return [v if isinstance(v, str) else next(cells) for v in values], False


def yes_or_no(value: Any) -> Any:
    """A cell for people: words in place of true and false."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return value
