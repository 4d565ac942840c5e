"""Stage ``cam_load``: what the cam asks of the shaft that drives it, for the reduction of the machine."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.machine.attached import Attached

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.shaftload:load_of_shaft"
takes = {"cam_synthesis": "follower"}
kind = Attached


def inputs(spec: CamTables) -> CamTask:
    """As of the forces."""
    return cam_of(spec, "asked", "limits", "loads", "guide")
