"""The constraints of a spec on the rows of a table from which one is chosen; read without what judges them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.feasibility.room import FeasibilityTables


def kept_rows(spec: FeasibilityTables, stage: str) -> FeasibilityTask | None:
    """All constraints, if one is on a column of this stage; else None."""
    if not any(each.stage == stage and each.column for each in spec.constraints):
        return None
    from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility

    return to_feasibility(spec)
