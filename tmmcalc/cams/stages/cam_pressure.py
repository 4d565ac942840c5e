"""Stage ``cam_pressure``: the pressure angle over the turn, and where it exceeds its limits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.pressure import Pressure
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The motion and the limits."""
    return cam_of(spec, "limits")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Pressure:
    """The angle at all rows, its largest values on rise and return."""
    from tmmcalc.cams.pressure import solve_pressure

    return solve_pressure(given, upstream["cam_synthesis"].follower)


def dump(result: Pressure) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Pressure:
    """Build the result from its record."""
    result: Pressure = from_record(Pressure, record)
    return result


def table(result: Pressure) -> Table:
    """One row a position."""
    from tmmcalc.cams.pressure import pressure_columns

    columns = pressure_columns(result)
    return Table(list(columns), list(columns.values()))
