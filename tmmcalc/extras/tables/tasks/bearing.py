"""From ``[bearing]`` to the bearing and how it turns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.bearing import BearingTask
    from tmmcalc.extras.room import ExtraTables


def to_bearing(spec: ExtraTables) -> BearingTask:
    """The bearing of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.bearing import BearingTask

    table = spec.bearing
    if table is None:
        raise UsageError("the spec has no [bearing]", remedy="add [bearing] with speed, inner, outer, roller and count")
    omega = table.speed
    if omega is None:
        omega = 2 * (table.wheel_speed or 0.0) / (table.wheel_diameter or 1.0)
    return BearingTask(
        omega=omega,
        inner=table.inner,
        outer=table.outer,
        roller=table.roller,
        count=table.count,
        angle=table.contact_angle,
        peak=tuple(table.peak or ()),
        rms=tuple(table.rms or ()),
    )
