"""Stage ``cam_pressure``: the pressure angle over the turn, and where it exceeds its limits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The motion and the limits."""
    return cam_of(spec, "limits")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Pressure:
    """The angle at all rows, its largest values on rise and return."""
    from tmmcalc.cams.pressure.solve import solve_pressure

    return solve_pressure(given, upstream["cam_synthesis"].follower)


def columns(result: Pressure) -> Mapping[str, Any]:
    """One row a position."""
    from tmmcalc.cams.pressure.solve import pressure_columns

    return pressure_columns(result)
