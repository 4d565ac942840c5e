"""Tables of several courses, one below the other: motions in time, a resonance curve after modes; each by itself."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.stage import STAGES
from tmmcalc.naming.table import Values

FEW = 2  # rows, with which a course begins to be one


class Course(NamedTuple):
    """What stands under one label of the first column: the columns that are numbers all along."""

    label: str
    meaning: str  # of the label
    along: str  # the name of the column that its rows go along; empty: it is not said
    columns: dict[str, Values]


def courses(stage: str, result: Any) -> list[Course]:
    """The courses of a stage's table; none where its rows are one course, or where one label comes back."""
    table = STAGES[stage].table(result)
    if table is None or not table.rows or np.asarray(table.columns[0]).dtype.kind != "U":
        return []
    labels = np.asarray(table.columns[0])
    runs = [(label, len([*run])) for label, run in groupby(labels.tolist())]
    if not 1 < len(runs) == len({label for label, _ in runs}) or min(count for _, count in runs) < FEW:
        return []
    said: Mapping[str, tuple[str, str]] = STAGES[stage].part("series") or {}
    found = []
    for label, _ in runs:
        here = labels == label
        columns = {header: _numbers(np.asarray(column)[here]) for header, column in _others(table)}
        numbers = {header: each for header, each in columns.items() if each is not None}
        meaning, along = said.get(label, (label, ""))
        found.append(Course(label, meaning, along, numbers))
    return found


def _others(table: Any) -> list[tuple[str, Any]]:
    return [*zip(table.header[1:], table.columns[1:], strict=True)]


def _numbers(cells: Any) -> Values | None:
    """A column as numbers, which a table of several courses has as texts; None where a cell is none."""
    if cells.dtype.kind == "b" or (cells.dtype.kind == "U" and not any("." in cell for cell in cells)):
        return None  # a word, a number of a wheel
    try:
        return np.asarray(cells, float)
    except ValueError:
        return None
