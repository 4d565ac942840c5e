"""The document of the position plan: both extremes, stroke and time ratio, and the table of positions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tmmcalc.core.quantity import keyed
from tmmcalc.linkage.plan import PositionPlan
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number


def plan_document(plan: PositionPlan, title: str, rows: Sequence[int] | None = None) -> Document:
    """Facts of the strokes and one row a position, or for the ``rows`` alone."""
    places = {"output": plan.output, "per": "rad" if plan.turns else "m", "unit": "rad" if plan.angular else "m"}

    def told(name: str, angular: bool) -> dict[str, Any]:
        return keyed(plan, f"{name}[deg]" if angular else name, **places)

    facts = [Fact("output", plan.output, keyed(plan, "output"))]
    if len(plan.dead_centres):
        values = told("dead_centres", plan.turns)
        text = " and ".join((angle if plan.turns else number)(x) for x in next(iter(values.values())))
        facts.append(Fact("dead centres", f"{text} {'deg' if plan.turns else 'm'}", values))
    if plan.stroke is not None:
        values = told("stroke", plan.angular)
        text = (angle if plan.angular else number)(next(iter(values.values())))
        facts.append(Fact("stroke", f"{text} {'deg' if plan.angular else 'm'}", values))
    if plan.time_ratio is not None:
        facts.append(Fact("time ratio K", number(plan.time_ratio), keyed(plan, "time_ratio")))
    columns = [
        *keyed(plan, "labels").items(),
        *told("phi", plan.turns).items(),
        *told("x", plan.turns).items(),
        *told("value", plan.angular).items(),
        *keyed(plan, "strokes", "extremes").items(),
    ]
    kept = range(len(plan.labels)) if rows is None else rows
    view = View([header for header, _ in columns], [[values[k] for k in kept] for _, values in columns])
    return Document(title, tuple(facts), table=view)
