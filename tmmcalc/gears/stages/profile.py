"""Stage ``profile``: the tooth profiles of the wheels of all pairs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.meshing.profiles import Profiles

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> int:
    """Points of each curve of a profile."""
    from tmmcalc.gears.tables.tasks.pair import profile_points

    return profile_points(spec)


def solve(given: int, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Profiles:
    """Half a tooth of every wheel."""
    from tmmcalc.gears.meshing.tooth import solve_profiles

    return solve_profiles(upstream["pair"], given)


def errors(result: Profiles) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"outline": max((wheel.error for wheel in result.wheels), default=0.0)}


def columns(result: Profiles) -> Mapping[str, Any]:
    """The points of half a tooth, one wheel after the other."""
    from tmmcalc.gears.meshing.tooth import profile_columns

    return profile_columns(result)
