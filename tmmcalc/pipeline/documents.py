"""The plan of a run: the stages in their order, which run, and why."""

from __future__ import annotations

from tmmcalc.core.plan import Plan
from tmmcalc.report.document import Document, View


def plan_document(plan: Plan, title: str) -> Document:
    """One row a stage."""
    steps = plan.steps
    columns = [
        [step.stage for step in steps],
        ["yes" if step.runs else "no" for step in steps],
        [step.reason for step in steps],
        [step.title for step in steps],
    ]
    return Document(title, table=View(["stage", "runs", "why", "gives"], columns))
