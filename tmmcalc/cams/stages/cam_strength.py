"""Stage ``cam_strength``: slip, shaft, stem, guide, pin and contact stress, each with its margin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The loads, and what shaft, stem, roller and contact have to bear."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> CamStrength:
    """Every requirement with its margin."""
    from tmmcalc.cams.strength.solve import solve_strength

    task = at_speed(given, upstream.get("motion"))
    return solve_strength(task, upstream["cam_synthesis"].follower, upstream["cam_forces"])


def columns(result: CamStrength) -> Mapping[str, Any]:
    """Slip, stresses and moments, one row a position."""
    from tmmcalc.cams.strength.columns import strength_columns

    return strength_columns(result)
