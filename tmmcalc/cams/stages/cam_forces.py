"""Stage ``cam_forces``: spring, reactions, friction and the torque of the cam."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The motion, masses, forces, spring, friction, guide."""
    return cam_of(spec, "asked", "limits", "loads", "guide")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> CamForces:
    """Everything that acts on the follower over the turn."""
    from tmmcalc.cams.forces.solve import solve_forces

    return solve_forces(at_speed(given, upstream.get("motion")), upstream["cam_synthesis"].follower)


def dump(result: CamForces) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> CamForces:
    """Build the result from its record."""
    result: CamForces = from_record(CamForces, record)
    return result


def table(result: CamForces) -> Table:
    """One row a position."""
    from tmmcalc.cams.forces.columns import force_columns

    columns = force_columns(result)
    return Table(list(columns), list(columns.values()))
