"""Stage ``cam_profile``: pitch and working profiles, curvature, the path of the tool."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The motion, the tool, limits of radii."""
    return cam_of(spec, "asked", "limits")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Profile:
    """All profiles, where they fail, the largest roller."""
    from tmmcalc.cams.profile.solve import solve_profile

    return solve_profile(given, upstream["cam_synthesis"].follower)


def columns(result: Profile) -> Mapping[str, Any]:
    """One row a position."""
    from tmmcalc.cams.profile.columns import profile_columns

    return profile_columns(result)
