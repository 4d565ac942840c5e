"""Stage ``cam_law``: the law of motion of the follower over the turn of the cam."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.lawresult import LawResult, law_columns, solve_law
from tmmcalc.cams.stages.parts import cam_of

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

inputs = cam_of
solve = solve_law
kind = LawResult
columns = law_columns
dense = "tmmcalc.cams.tables.tasks.placed:with_positions"
declares = ("tmmcalc.cams.further",)
further = "tmmcalc.cams.further:of_law"
details = "tmmcalc.cams.laws.details:law_details"


def packages(spec: CamTables) -> tuple[str, ...]:
    """A law by points is a spline."""
    cam = spec.cam
    laws = () if cam is None else (cam.law, cam.rise_law, cam.return_law)
    return ("scipy.interpolate",) if any(getattr(law, "points", None) is not None for law in laws) else ()
