"""From ``[dyad]`` to the dyad and the states of its outer joints."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.dyadstate import DyadTask, LinkPoint, Port

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.tables.dyad import PortTable


def to_dyad(spec: LinkageTables) -> DyadTask:
    """The dyad of the spec; raises `UsageError` if it has none."""
    table = spec.dyad
    if table is None:
        raise UsageError("the spec has no [dyad]", remedy="add [dyad] with kind, its lengths, first and second")
    return DyadTask(
        kind=table.kind,
        length_a=table.length_a,
        length_b=table.length_b,
        offset_a=table.offset_a or 0.0,
        offset_b=table.offset_b or 0.0,
        turn=pi / 2 if table.turn is None else table.turn,
        variant=table.variant or 1,
        first=_port(table.first),
        second=_port(table.second),
        points=tuple(
            LinkPoint(name, link, x, y)
            for link, points in (("a", table.points_a), ("b", table.points_b))
            for name, (x, y) in points.items()
        ),
    )


def _port(table: PortTable) -> Port:
    return Port(
        tuple(table.point),
        tuple(table.velocity),
        tuple(table.acceleration),
        table.angle or 0.0,
        table.omega or 0.0,
        table.eps or 0.0,
    )
