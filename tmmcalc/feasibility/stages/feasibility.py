"""Stage ``feasibility``: whether results keep the named constraints of the spec.

Of a synthesis every design is judged, by its own row of the table and by the stages of its ready spec.
"""

from __future__ import annotations

from typing import Any

from tmmcalc.core.stage import Another
from tmmcalc.feasibility.judge import Feasibility, FeasibilityTask
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility

inputs = to_feasibility
kind = Feasibility


def solve(task: FeasibilityTask, another: Another, **upstream: Any) -> Feasibility:
    """Judge every constraint; raises `UsageError` for a quantity that the stage does not tell."""
    if "synthesis" not in upstream:
        return judged(task, upstream)
    from tmmcalc.feasibility.stages.candidates import judge_designs

    return judge_designs(task, upstream, another)


def errors(result: Feasibility) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"margins": result.error}
