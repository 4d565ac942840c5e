"""Stage ``cam_strength``: slip, shaft, stem, guide, pin and contact stress, each with its margin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.strength.solve:solve_strength"
takes = {"cam_synthesis": "follower"}
kind = CamStrength
columns = "tmmcalc.cams.strength.columns:strength_columns"
declares = ("tmmcalc.cams.further",)
further = "tmmcalc.cams.further:of_strength"


def inputs(spec: CamTables) -> CamTask:
    """The loads, and what shaft, stem, roller and contact have to bear."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements")
