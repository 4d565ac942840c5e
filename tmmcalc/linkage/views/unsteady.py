"""The linkage over the time of a motion from rest to rest."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.unsteady.columns import TIME
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.views.linkage import MovingLinkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import View, seconds_of


def views(order: Order) -> Iterator[View]:
    """The linkage as its input takes it from the beginning to the end."""
    result: Unsteady = order.results["unsteady"]
    if len(result.t) > 1:
        moved = MovingLinkage(
            to_linkage(order.spec.linkage), order.results["kinematics"], result.drive[0], result.drive[1]
        )
        yield View(
            name="unsteady",
            title="Unsteady motion of the mechanism",
            symbol="t",
            unit="s",
            values=result.t,
            whole=False,
            column=TIME.key,
            steps=(),
            box=moved.box,
            bodies=tuple(moved.bodies()),
            frame=tuple(moved.frame()),
            spots=tuple(moved.spots()),
            layers=tuple(moved.layers("unsteady")),
            shown=("unsteady.v", *(f"unsteady.vS_{output}" for output in result.outputs[:1])),
            stages=("unsteady",),
            seconds=seconds_of(result.law.duration),
        )
