"""Stage ``feasibility``: whether results keep the named constraints of the spec.

Of a synthesis every design is judged, by its own row of the table and by the stages of its ready spec.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import STAGES, Another
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.scene import Scene, Whole

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables

kind = Feasibility


def inputs(spec: FeasibilityTables) -> tuple[FeasibilityTask, Whole | None]:
    """The constraints, and the whole spec if one may be on a place between rows, or on what is by choice."""
    task = to_feasibility(spec)
    return task, Whole(spec) if any(_beyond(each) for each in task.constraints if each.given is None) else None


def _beyond(constraint: Constraint) -> bool:
    """Whether a constraint may ask for more than stands in results."""
    place = constraint.asked.place
    if place is not None and place.column:
        return True
    stages = [constraint.stage] if constraint.stage in STAGES else STAGES
    return any(STAGES[name].part(part) is not None for name in stages for part in ("further", "details"))


def solve(
    task: FeasibilityTask, whole: Whole | None, another: Another, every: Mapping[str, Any], **upstream: Any
) -> Feasibility:
    """Judge every constraint; raises `UsageError` for a quantity that the stage does not tell.

    ``every`` are the results of the scene so far, those that the stages asked about have read among them.
    """
    if "synthesis" not in upstream:
        return judged(task, upstream, Scene(whole and whole.spec, every))
    from tmmcalc.feasibility.stages.candidates import judge_designs

    return judge_designs(task, upstream, another)


def errors(result: Feasibility) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"margins": result.error}
