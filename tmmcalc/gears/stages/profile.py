"""Stage ``profile``: the tooth profiles of the wheels of all pairs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.gears.meshing.profiles import Profiles

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> int:
    """Points of each curve of a profile."""
    from tmmcalc.gears.tables.tasks.pair import profile_points

    return profile_points(spec)


def solve(given: int, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Profiles:
    """Half a tooth of every wheel."""
    from tmmcalc.gears.meshing.tooth import solve_profiles

    return solve_profiles(upstream["pair"], given)


def dump(result: Profiles) -> Record:
    """Arrays by the names of the fields: ``wheels.0.x``, ..."""
    return to_record(result, {"outline": max((wheel.error for wheel in result.wheels), default=0.0)})


def load(record: Record) -> Profiles:
    """Build the result from its record."""
    result: Profiles = from_record(Profiles, record)
    return result


def table(result: Profiles) -> Table:
    """The points of half a tooth, one wheel after the other."""
    from tmmcalc.gears.meshing.tooth import profile_columns

    columns = profile_columns(result)
    return Table(list(columns), list(columns.values()))
