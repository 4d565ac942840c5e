"""Stage ``cam_strength``: slip, shaft, stem, guide, pin and contact stress, each with its margin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The loads, and what shaft, stem, roller and contact have to bear."""
    return cam_of(spec, "asked", "limits", "loads", "guide", "requirements")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> CamStrength:
    """Every requirement with its margin."""
    from tmmcalc.cams.strength.solve import solve_strength

    task = at_speed(given, upstream.get("motion"))
    return solve_strength(task, upstream["cam_synthesis"].follower, upstream["cam_forces"])


def dump(result: CamStrength) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> CamStrength:
    """Build the result from its record."""
    result: CamStrength = from_record(CamStrength, record)
    return result


def table(result: CamStrength) -> Table:
    """Slip, stresses and moments, one row a position."""
    from tmmcalc.cams.strength.columns import strength_columns

    columns = strength_columns(result)
    return Table(list(columns), list(columns.values()))
