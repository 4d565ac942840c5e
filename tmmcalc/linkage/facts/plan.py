"""The document of the position plan: both extremes, stroke and time ratio, and the table of positions."""

from __future__ import annotations

import math

from tmmcalc.linkage.plan import PositionPlan
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number


def plan_document(plan: PositionPlan, title: str) -> Document:
    """Facts of the strokes and one row a position."""
    across, unit = (math.degrees(1.0), "deg") if plan.turns else (1.0, "m")
    out, of = (math.degrees(1.0), "deg") if plan.angular else (1.0, "m")
    write = angle if plan.turns else number
    centres = [across * x for x in plan.dead_centres.tolist()]
    text = " and ".join(write(x) for x in centres)
    facts = [Fact("output", plan.output, {"output": plan.output})]
    if centres:
        facts.append(Fact("dead centres", f"{text} {unit}", {f"dead_centres[{unit}]": centres}))
    if plan.stroke is not None:
        stroke = out * plan.stroke
        shown = angle(stroke) if plan.angular else number(stroke)
        facts.append(Fact("stroke", f"{shown} {of}", {f"stroke[{of}]": stroke}))
    if plan.time_ratio is not None:
        facts.append(Fact("time ratio K", number(plan.time_ratio), {"K": plan.time_ratio}))
    headers = ["i", f"phi[{unit}]", f"input[{unit}]", f"{plan.output}[{of}]", "stroke", "extreme"]
    columns = [
        list(plan.labels),
        [across * v for v in plan.phi.tolist()],
        [across * v for v in plan.x.tolist()],
        [out * v for v in plan.value.tolist()],
        list(plan.strokes),
        list(plan.extremes),
    ]
    return Document(title, tuple(facts), table=View(headers, columns))
