"""Stage ``cam_forces``: spring, reactions, friction and the torque of the cam."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.machine.motion import Motion

kind = CamForces
columns = "tmmcalc.cams.forces.columns:force_columns"


def inputs(spec: CamTables) -> CamTask:
    """The motion, masses, forces, spring, friction, guide."""
    return cam_of(spec, "asked", "limits", "loads", "guide")


def solve(task: CamTask, cam_synthesis: Synthesis, motion: Motion | None = None) -> CamForces:
    """Everything that acts on the follower over the turn."""
    from tmmcalc.cams.forces.solve import solve_forces

    return solve_forces(at_speed(task, motion), cam_synthesis.follower)
