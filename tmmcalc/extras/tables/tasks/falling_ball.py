"""From ``[falling_ball]`` to the ball and what acts on it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.falling_ball import BallTask
    from tmmcalc.extras.room import ExtraTables


def to_ball(spec: ExtraTables) -> BallTask:
    """The ball of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.falling_ball import BallTask

    table = spec.falling_ball
    if table is None:
        raise UsageError("the spec has no [falling_ball]", remedy="add [falling_ball] with radius, drag and decay")
    relative = table.relative_speed
    return BallTask(
        radius=table.radius,
        drag=table.drag,
        decay=table.decay,
        gravity=table.gravity,
        sign=1 if table.reaction == "accelerating" else -1,
        relative=None if isinstance(relative, str) else relative,
        initial=table.initial_speed,
        times=tuple(table.times),
        duration=table.duration,
        rows=table.rows,
    )
