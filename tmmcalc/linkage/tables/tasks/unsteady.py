"""From the table ``[unsteady]`` to what is asked of an unsteady motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.tables.unsteady import SENSES
from tmmcalc.linkage.unsteady.task import UnsteadyTask

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables


def to_unsteady(spec: LinkageTables) -> UnsteadyTask:
    """The unsteady motion of the spec; raises `UsageError` if it has none."""
    table = spec.unsteady
    if table is None:
        remedy = "add [unsteady] with to or duration, speed and acceleration"
        raise UsageError("the spec has no [unsteady]", remedy=remedy)
    return UnsteadyTask(
        acceleration=table.acceleration,
        speed=table.speed,
        start=table.start,
        end=table.end,
        travel=table.travel,
        duration=table.duration,
        output=table.output,
        sense=None if table.sense is None else SENSES[table.sense],
        steps=table.steps,
    )


def with_steps(spec: LinkageTables, count: int) -> LinkageTables:
    """The spec with so many equal steps of the time at least, its own among them."""
    table = spec.unsteady
    if table is None:
        raise UsageError("the spec has no [unsteady]")
    dense = table.model_copy(update={"steps": table.steps * -(-count // table.steps)})
    whole: Any = spec  # the root of the spec, which is put together of the rooms
    placed: LinkageTables = whole.model_copy(update={"unsteady": dense})
    return placed
