"""Stage ``cam_forces``: spring, reactions, friction and the torque of the cam."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.forces.solve:solve_forces"
takes = {"cam_synthesis": "follower"}
kind = CamForces
columns = "tmmcalc.cams.forces.columns:force_columns"
dense = "tmmcalc.cams.tables.tasks.placed:with_positions"
declares = ("tmmcalc.cams.further", "tmmcalc.cams.lawresult", "Q", "M_Q")
further = "tmmcalc.cams.further:of_forces"


def inputs(spec: CamTables) -> CamTask:
    """The motion, masses, forces, spring, friction, guide."""
    return cam_of(spec, "asked", "limits", "loads", "guide")
