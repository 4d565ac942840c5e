"""Stage ``cam_pressure``: the pressure angle over the turn, and where it exceeds its limits."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.pressure.solve:solve_pressure"
takes = {"cam_synthesis": "follower"}
kind = Pressure
columns = "tmmcalc.cams.pressure.solve:pressure_columns"
dense = "tmmcalc.cams.tables.tasks.placed:with_positions"
declares = ()


def inputs(spec: CamTables) -> CamTask:
    """The motion and the limits."""
    return cam_of(spec, "limits")
