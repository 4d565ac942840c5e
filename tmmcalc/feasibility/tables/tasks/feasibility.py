"""From ``[[constraints]]`` and ``[feasibility]`` to the task of the feasibility stage."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from tmmcalc.feasibility.judge import Constraint, FeasibilityTask

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables


def to_feasibility(spec: FeasibilityTables) -> FeasibilityTask:
    """The constraints in their order, and the rule that combines them."""
    constraints = tuple(
        Constraint(each.name, each.stage, each.value, each.column, cast(Any, each.of), each.at_least, each.at_most)
        for each in spec.constraints
    )
    table = spec.feasibility
    if table is None:
        return FeasibilityTask(constraints)
    return FeasibilityTask(constraints, table.rule, cast(Any, table.form), table.smoothness)
