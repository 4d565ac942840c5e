"""From ``[tie_down]`` to the load and its ties."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables
    from tmmcalc.extras.tie_down import TieDownTask


def to_tie_down(spec: ExtraTables) -> TieDownTask:
    """The load of the spec and its ties; raises `UsageError` if it has none."""
    from tmmcalc.extras.tie_down import Support, Thread, TieDownTask

    table = spec.tie_down
    if table is None:
        raise UsageError(
            "the spec has no [tie_down]", remedy="add [tie_down] with weight, factor, elevation and friction"
        )
    thread, held = table.thread, table.support
    return TieDownTask(
        weight=table.weight,
        factor=table.factor,
        elevation=table.elevation,
        plan=table.plan_angle,
        friction=table.friction,
        preload=table.preload or 0.0,
        thread=None
        if thread is None
        else Thread(thread.moment, thread.diameter, thread.lead_angle, thread.friction_angle),
        support=None
        if held is None
        else Support(held.weight, held.friction, held.base, held.arm, held.cradle_arm, held.diameter),
        section=table.section,
        strength=table.strength,
    )
