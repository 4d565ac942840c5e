"""Stage ``cam_strength``: slip, shaft, stem, guide, pin and contact stress, each with its margin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.machine.motion import Motion

kind = CamStrength
columns = "tmmcalc.cams.strength.columns:strength_columns"


def inputs(spec: CamTables) -> CamTask:
    """The loads, and what shaft, stem, roller and contact have to bear."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements")


def solve(task: CamTask, cam_synthesis: Synthesis, cam_forces: CamForces, motion: Motion | None = None) -> CamStrength:
    """Every requirement with its margin."""
    from tmmcalc.cams.strength.solve import solve_strength

    return solve_strength(at_speed(task, motion), cam_synthesis.follower, cam_forces)
