"""One set of results by stage judged by the constraints of a scene."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import Quantity, facts, named
from tmmcalc.core.stage import STAGES
from tmmcalc.feasibility.judge import OF, ROWS, Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.quantities import limits, of_name, place


def judged(task: FeasibilityTask, upstream: Mapping[str, Any]) -> Feasibility:
    """Judge one set of results by stage."""
    found = {}
    for constraint in task.constraints:
        value, unit = _quantity(constraint, upstream)
        found[constraint.name] = value, unit, *limits(constraint, unit)
    return judge(task, found)


def _quantity(constraint: Constraint, upstream: Mapping[str, Any]) -> Quantity:
    """Value and unit of the quantity of a constraint."""
    if constraint.stage not in upstream:
        raise UsageError(
            f"this scene has no {constraint.stage}",
            where=place(constraint),
            remedy="tmmcalc plan says why a stage is left out",
        )
    result = upstream[constraint.stage]
    told = dict(facts(constraint.stage, result)) if constraint.value else dict(of_columns(constraint, result))
    return of_name(constraint, told)


def of_columns(constraint: Constraint, result: Any) -> Iterator[tuple[str, Quantity]]:
    """What is asked of every column of numbers of the stage's table, by name."""
    made = STAGES[constraint.stage].table(result)
    for header, column in zip(made.header, made.columns, strict=True) if made else ():
        if np.asarray(column).dtype.kind in "fi" and len(column):
            name, unit = named(header)
            yield name, (_asked(constraint, result, np.asarray(column, float)), unit)


def _asked(constraint: Constraint, result: Any, column: np.ndarray) -> float:
    """Where rows are sets to choose from the value of the chosen one, the first where none is."""
    if constraint.stage not in ROWS:
        return float(OF[constraint.of](column))
    return float(column[result.winner.place if constraint.stage == "criteria" else 0])
