"""Stage ``cam_elastic``: residual and steady vibration of the follower as one mass on an elastic train."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The motion, the mass, the elastic train."""
    return cam_of(spec, "asked", "loads", "elastic")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> ElasticResult:
    """The vibration over the turn, at the speed of the machine if it is known."""
    from tmmcalc.cams.elastic import solve_elastic

    return solve_elastic(at_speed(given, upstream.get("motion")), upstream["cam_synthesis"].follower)


def columns(result: ElasticResult) -> Mapping[str, Any]:
    """One row a point of the panels."""
    from tmmcalc.cams.elastic import elastic_columns

    return elastic_columns(result)
