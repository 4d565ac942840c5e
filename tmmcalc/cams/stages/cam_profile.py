"""Stage ``cam_profile``: pitch and working profiles, curvature, the path of the tool."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The motion, the tool, limits of radii."""
    return cam_of(spec, "asked", "limits")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Profile:
    """All profiles, where they fail, the largest roller."""
    from tmmcalc.cams.profile.solve import solve_profile

    return solve_profile(given, upstream["cam_synthesis"].follower)


def dump(result: Profile) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Profile:
    """Build the result from its record."""
    result: Profile = from_record(Profile, record)
    return result


def table(result: Profile) -> Table:
    """One row a position."""
    from tmmcalc.cams.profile.columns import profile_columns

    columns = profile_columns(result)
    return Table(list(columns), list(columns.values()))
