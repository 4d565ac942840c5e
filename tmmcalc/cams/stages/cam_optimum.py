"""Stage ``cam_optimum``: the lowest mechanism within all constraints, and the blocking contour."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The loads, the requirements, the search."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements", "optimum")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> CamOptimum:
    """Contour, least height, active constraints, what relaxing them would buy; at the speed of the machine."""
    from tmmcalc.cams.optimum.solve import solve_optimum

    return solve_optimum(at_speed(given, upstream.get("motion")), upstream["cam_synthesis"].follower)
