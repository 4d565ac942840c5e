"""Stage ``cam_optimum``: the lowest mechanism within all constraints, and the blocking contour."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.machine.motion import Motion

kind = CamOptimum


def inputs(spec: CamTables) -> CamTask:
    """The loads, the requirements, the search."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements", "optimum")


def solve(task: CamTask, cam_synthesis: Synthesis, motion: Motion | None = None) -> CamOptimum:
    """Contour, least height, active constraints, what relaxing them would buy; at the speed of the machine."""
    from tmmcalc.cams.optimum.solve import solve_optimum

    return solve_optimum(at_speed(task, motion), cam_synthesis.follower)
