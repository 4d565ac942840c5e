"""The linkage that a synthesis found, over its cycle, with the points that were wanted."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.tables.tasks.placed import with_positions
from tmmcalc.linkage.views.kinematics import Cycle
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import Mark, View

POSITIONS = 360


def views(order: Order) -> Iterator[View]:
    """The solution that is chosen; none where the scene goes on with it and shows it so."""
    if "kinematics" in order.results:
        return
    result: Synthesis = order.results["synthesis"]
    chosen = order.solved("feasibility").chosen if order.spec.constraints else 1
    design = result.designs[chosen - 1]
    mechanism = to_linkage(with_positions(order.read(design.spec), POSITIONS).linkage)
    view = Cycle(mechanism, solve_kinematics(mechanism)).view()
    precision = design.precision
    wanted = () if precision is None else tuple(Mark("cross", (complex(z),)) for z in precision.points)
    yield view._replace(
        name="synthesis",
        title="Linkage that was found",
        frame=(*view.frame, *wanted),
        layers=(),
        shown=(),
        plans=tuple,
        stages=("synthesis",),
    )
