"""Stage ``cam_synthesis``: sizes of the cam and its follower, given or found under the limits of the pressure angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.synthesis.solve:solve_synthesis"
kind = Synthesis
found = "tmmcalc.cams.tables.found:of_synthesis"
details = "tmmcalc.cams.synthesis.candidates:size_candidates"


def inputs(spec: CamTables) -> CamTask:
    """The motion, sizes that are given, limits of pressure angle and radii."""
    return cam_of(spec, "asked", "limits")
