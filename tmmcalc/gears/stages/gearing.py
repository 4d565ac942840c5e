"""Stage ``gearing``: a train that is written out, its speeds, torques, power flow and efficiency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.gearing import Gearing, solve_gearing
from tmmcalc.gears.gearingtask import GearingTask
from tmmcalc.gears.members import member_columns

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> GearingTask | None:
    """The members, the meshes, what is known of speeds and torques."""
    from tmmcalc.gears.tables.tasks.gearing import to_gearing

    return to_gearing(spec)


def solve(given: GearingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Gearing:
    """The train in motion."""
    return solve_gearing(given)


def columns(result: Gearing) -> Mapping[str, Any]:
    """Speeds, torques and powers, one row a member."""

    return member_columns(result)
