"""Stage ``cam_law``: the law of motion of the follower over the turn of the cam."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """Phases, laws, the rows of the table, the speed."""
    return cam_of(spec)


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> LawResult:
    """Displacement and its derivatives at all rows; what the laws cost."""
    from tmmcalc.cams.lawresult import solve_law

    return solve_law(given)


def columns(result: LawResult) -> Mapping[str, Any]:
    """One row a position."""
    from tmmcalc.cams.lawresult import law_columns

    return law_columns(result)


def packages(spec: CamTables) -> tuple[str, ...]:
    """A law by points is a spline."""
    cam = spec.cam
    laws = () if cam is None else (cam.law, cam.rise_law, cam.return_law)
    return ("scipy.interpolate",) if any(getattr(law, "points", None) is not None for law in laws) else ()
