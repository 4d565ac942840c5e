"""Stage ``feasibility``: whether results keep the named constraints of the spec.

Of a synthesis every design is judged, by its own row of the table and by the stages of its ready spec.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import Another
from tmmcalc.feasibility.judge import Feasibility, FeasibilityTask
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.anew import Again, again_of

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables

kind = Feasibility


def inputs(spec: FeasibilityTables) -> tuple[FeasibilityTask, tuple[Again, ...]]:
    """The constraints, and what is read anew for those on places between the rows of tables."""
    task = to_feasibility(spec)
    return task, again_of(spec, [each.asked for each in task.constraints if each.given is None])


def solve(task: FeasibilityTask, again: Sequence[Again], another: Another, **upstream: Any) -> Feasibility:
    """Judge every constraint; raises `UsageError` for a quantity that the stage does not tell."""
    if "synthesis" not in upstream:
        return judged(task, upstream, again)
    from tmmcalc.feasibility.stages.candidates import judge_designs

    return judge_designs(task, upstream, another)


def errors(result: Feasibility) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"margins": result.error}
