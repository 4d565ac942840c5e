"""Stage ``feasibility``: whether results keep the named constraints of the spec.

Of a synthesis every design is judged, by its own row of the table and by the stages of its ready spec.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import Another
from tmmcalc.feasibility.judge import Feasibility, FeasibilityTask
from tmmcalc.feasibility.quantities import place
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.spec.telling import Again, again_of

if TYPE_CHECKING:
    from tmmcalc.core.plan import Plan
    from tmmcalc.feasibility.room import FeasibilityTables

kind = Feasibility


def inputs(spec: FeasibilityTables) -> tuple[FeasibilityTask, tuple[Again, ...]]:
    """The constraints, and what is read anew for those on places between the rows of tables."""
    task = to_feasibility(spec)
    return task, again_of(spec, [each.asked for each in task.constraints if each.given is None])


def unfit(spec: FeasibilityTables, scene: Plan) -> UsageError | None:
    """A constraint on a stage that the scene leaves out; the designs of a synthesis have stages of their own."""
    if "synthesis" in scene.running:
        return None
    for constraint in to_feasibility(spec).constraints:
        stage = "" if constraint.given is not None else constraint.asked.stage
        if stage and not scene.step(stage).runs:
            return UsageError(
                f"this scene has no {stage}",
                where=place(constraint),
                remedy=f"{scene.step(stage).reason}; tmmcalc plan tells of all stages",
            )
    return None


def solve(task: FeasibilityTask, again: Sequence[Again], another: Another, **upstream: Any) -> Feasibility:
    """Judge every constraint; raises `UsageError` for a quantity that the stage does not tell."""
    if "synthesis" not in upstream:
        return judged(task, upstream, again)
    from tmmcalc.feasibility.stages.candidates import judge_designs

    return judge_designs(task, upstream, another)


def errors(result: Feasibility) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"margins": result.error}
