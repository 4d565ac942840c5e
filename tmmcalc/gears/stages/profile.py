"""Stage ``profile``: the tooth profiles of the wheels of all pairs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.gears.meshing.profiles import Profiles
from tmmcalc.gears.tables.tasks.pair import profile_points

if TYPE_CHECKING:
    from tmmcalc.gears.meshing.results import Pairs

inputs = profile_points
kind = Profiles
columns = "tmmcalc.gears.meshing.tooth:profile_columns"
declares = ()


def solve(points: int, pair: Pairs) -> Profiles:
    """Half a tooth of every wheel."""
    from tmmcalc.gears.meshing.tooth import solve_profiles

    return solve_profiles(pair, points)


def errors(result: Profiles) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"outline": max((wheel.error for wheel in result.wheels), default=0.0)}
