"""Stage ``cam_pressure``: the pressure angle over the turn, and where it exceeds its limits."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis

kind = Pressure
columns = "tmmcalc.cams.pressure.solve:pressure_columns"


def inputs(spec: CamTables) -> CamTask:
    """The motion and the limits."""
    return cam_of(spec, "limits")


def solve(task: CamTask, cam_synthesis: Synthesis) -> Pressure:
    """The angle at all rows, its largest values on rise and return."""
    from tmmcalc.cams.pressure.solve import solve_pressure

    return solve_pressure(task, cam_synthesis.follower)
