"""Stage ``cam_profile``: pitch and working profiles, curvature, the path of the tool."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.profile.solve:solve_profile"
takes = {"cam_synthesis": "follower"}
kind = Profile
columns = "tmmcalc.cams.profile.columns:profile_columns"
dense = "tmmcalc.cams.tables.tasks.placed:with_positions"
declares = ()
further = "tmmcalc.cams.further:of_profile"


def inputs(spec: CamTables) -> CamTask:
    """The motion, the tool, limits of radii."""
    return cam_of(spec, "asked", "limits")
