"""Stage ``cam_optimum``: the lowest mechanism within all constraints, and the blocking contour."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.optimum.solve:solve_optimum"
takes = {"cam_synthesis": "follower"}
kind = CamOptimum
found = "tmmcalc.cams.tables.found:of_optimum"


def inputs(spec: CamTables) -> CamTask:
    """The loads, the requirements, the search."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements", "optimum")
