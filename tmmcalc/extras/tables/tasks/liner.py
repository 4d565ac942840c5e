"""From ``[liner]`` to the ring and the shell."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.liner import LinerTask
    from tmmcalc.extras.room import ExtraTables


def to_liner(spec: ExtraTables) -> LinerTask:
    """The liner of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.liner import Clamp, LinerTask

    table = spec.liner
    if table is None:
        raise UsageError(
            "the spec has no [liner]", remedy="add [liner] with radius, thickness, ring_outer, ring_width and moment"
        )
    clamp = table.clamp
    return LinerTask(
        radius=table.radius,
        thickness=table.thickness,
        outer=table.ring_outer,
        width=table.ring_width,
        young=table.young,
        poisson=table.poisson,
        load=table.load,
        moment=table.moment or 0.0,
        clamp=None if clamp is None else Clamp(clamp.gas_pressure, clamp.bore, clamp.arm, clamp.factor),
        pressure=table.pressure,
        length=table.length,
        continuity=table.continuity,
        allowed=table.allowed,
        rows=table.rows,
    )
