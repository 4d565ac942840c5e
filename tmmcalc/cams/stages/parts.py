"""What of a cam a stage reads: the rest is set to nothing, so that only what matters makes a stored result stale."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Guide, Loads, Requirements

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

NO_LIMITS = AngleLimits(rise=0.0, back=None)


def cam_of(spec: CamTables, *parts: str) -> CamTask:
    """The cam of a spec with its motion and speed, and of its other parts those that are named."""
    from tmmcalc.cams.tables.tasks.cam import to_cam

    task = to_cam(spec)
    nothing: dict[str, Any] = {
        "asked": Asked(task.asked.kind, task.asked.sense),
        "limits": NO_LIMITS,
        "loads": None if task.loads is None else Loads(task.loads.speed, pivot_radius=task.loads.pivot_radius),
        "guide": Guide(),
        "requirements": Requirements(),
        "optimum": None,
        "elastic": None,
    }
    return replace(task, **{name: value for name, value in nothing.items() if name not in parts})
