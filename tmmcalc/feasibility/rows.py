"""Constraints on the rows of a table whose rows are designs to choose from: each row is judged on its own.

A row is kept as long as the rule may hold with it, whatever becomes of the constraints on other stages.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.facts import named
from tmmcalc.core.records import record
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask
from tmmcalc.feasibility.quantities import limits, of_name
from tmmcalc.feasibility.rule import failing, may_hold


@record
class Kept:
    """Which rows are kept, how many each constraint removed (one row may count under several), and what was there."""

    rows: NDArray[np.bool_]  # (n,)
    removed: dict[str, int]
    told: tuple[str, ...]  # least and largest value of every constrained column, in words


def on_rows(task: FeasibilityTask, stage: str) -> tuple[Constraint, ...]:
    """The constraints on columns of a stage."""
    return tuple(each for each in task.constraints if each.stage == stage and each.column)


def keep(task: FeasibilityTask, stage: str, columns: Mapping[str, NDArray[Any]]) -> Kept:
    """Judge the rows of a table by its columns, header to values (n,); raises `UsageError` for a column it lacks."""
    numbers = {named(header): column for header, column in columns.items() if column.dtype.kind in "fi"}
    told = {name: (column, unit) for (name, unit), column in numbers.items()}
    count = len(next(iter(columns.values())))
    truths, words = {}, []
    for constraint in on_rows(task, stage):
        values, unit = of_name(constraint, told)
        truths[constraint.name] = _within(values, *limits(constraint, unit))
        words.append(_range(constraint, values, unit))
    rows = may_hold(task.combined, truths, (count,))
    return Kept(rows, _removed(task, truths, rows), tuple(words))


def _within(values: NDArray[Any], low: float | None, high: float | None) -> NDArray[np.bool_]:
    inside = np.ones(len(values), bool)
    if low is not None:
        inside &= values >= low
    if high is not None:
        inside &= values <= high
    return inside


def _removed(task: FeasibilityTask, truths: Mapping[str, NDArray[np.bool_]], rows: NDArray[np.bool_]) -> dict[str, int]:
    """Rows that are not kept, by the constraints at fault; what is not known is taken as kept."""
    removed = dict.fromkeys(truths, 0)
    unknown = {constraint.name: True for constraint in task.constraints}
    patterns = np.stack([truth[~rows] for truth in truths.values()], axis=1).tolist() if truths else []
    counts: dict[tuple[bool, ...], int] = {}
    for pattern in map(tuple, patterns):
        counts[pattern] = counts.get(pattern, 0) + 1
    for pattern, count in counts.items():
        state = dict(zip(truths, pattern, strict=True))
        for name in failing(task.combined, {**unknown, **state}):
            if name in removed:
                removed[name] += count
    return removed


def _range(constraint: Constraint, values: NDArray[Any], unit: str) -> str:
    if not len(values):
        return f"{constraint.name}: no sets"
    low, high = (f"{float(end):.5g} {unit}".strip() for end in (np.min(values), np.max(values)))
    return f"{constraint.name}: {constraint.column} is {low} to {high}"
