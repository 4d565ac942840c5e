"""The table of a stage's result as names see it: what its rows are called, and its columns of numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.columns import Column
from tmmcalc.core.facts import named
from tmmcalc.core.stage import STAGES

Values = NDArray[np.floating[Any]]


class Table(NamedTuple):
    """A table of a result: what every row is, and its columns of numbers."""

    first: Any  # (n,) what the rows are called
    headers: list[str]
    make: Callable[[int], Any]  # the column (n,) of a header by its number
    further: int = 0  # of its columns, the last, are by choice

    @property
    def labels(self) -> list[str]:
        """What the rows are called, in the words of a place."""
        return [f"{label:g}" if isinstance(label, float) else str(label) for label in self.first.tolist()]

    def column(self, header: str) -> Values:
        """The values under a header; NaN where a column by choice has none."""
        return np.asarray(self.make(self.headers.index(header)), float)

    def with_columns(self, further: Sequence[Column]) -> Table:
        """The table with columns behind its own."""
        own = len(self.headers)

        def make(at: int) -> Any:
            return self.make(at) if at < own else further[at - own].make()

        return Table(self.first, [*self.headers, *(each.header for each in further)], make, len(further))


def table_of(stage: str, result: Any) -> Table | None:
    """The columns of numbers of a result; None if it has no rows."""
    made = STAGES[stage].table(result)
    if made is None or not made.rows:
        return None
    first = np.asarray(made.columns[0])
    numbers = [k for k in range(len(made.header)) if k or first.dtype.kind in "fi"]

    def make(at: int) -> Any:
        return made.columns[numbers[at]]

    return Table(first, [made.header[k] for k in numbers], make)


def columns_of(stage: str, result: Any) -> list[str]:
    """The columns of numbers of a stage by name, with the stage and without unit."""
    table = table_of(stage, result)
    return [f"{stage}.{named(header)[0]}" for header in table.headers] if table else []
