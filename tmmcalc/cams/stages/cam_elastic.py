"""Stage ``cam_elastic``: residual and steady vibration of the follower as one mass on an elastic train."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The motion, the mass, the elastic train."""
    return cam_of(spec, "asked", "loads", "elastic")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> ElasticResult:
    """The vibration over the turn, at the speed of the machine if it is known."""
    from tmmcalc.cams.elastic import solve_elastic

    return solve_elastic(at_speed(given, upstream.get("motion")), upstream["cam_synthesis"].follower)


def dump(result: ElasticResult) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> ElasticResult:
    """Build the result from its record."""
    result: ElasticResult = from_record(ElasticResult, record)
    return result


def table(result: ElasticResult) -> Table:
    """One row a point of the panels."""
    from tmmcalc.cams.elastic import elastic_columns

    columns = elastic_columns(result)
    return Table(list(columns), list(columns.values()))
