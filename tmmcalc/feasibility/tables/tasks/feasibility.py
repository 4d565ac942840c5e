"""From ``[[constraints]]`` and ``[feasibility]`` to the task of the feasibility stage."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from tmmcalc.feasibility.judge import Constraint, FeasibilityTask

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables
    from tmmcalc.feasibility.tables.constraints import ConstraintTable


def to_feasibility(spec: FeasibilityTables) -> FeasibilityTask:
    """The constraints in their order, and the rule that combines them."""
    constraints = tuple(map(_constraint, spec.constraints))
    table = spec.feasibility
    if table is None:
        return FeasibilityTask(constraints)
    return FeasibilityTask(constraints, table.rule, cast(Any, table.form), table.smoothness)


def _constraint(table: ConstraintTable) -> Constraint:
    """On a result, or on what is given: a function that is not negative where it holds, of a truth +1 or -1."""
    if table.stage is not None:
        value = None if table.value is None else str(table.value)
        return Constraint(table.name, table.stage, value, table.column, table.of, table.at_least, table.at_most)
    if table.value is not None:
        return Constraint(table.name, at_least=table.at_least, at_most=table.at_most, given=table.value)
    if table.function is not None:
        return Constraint(table.name, at_least=0.0, given=table.function, sense="function")
    return Constraint(table.name, at_least=0.0, given=1.0 if table.holds else -1.0, sense="truth")
