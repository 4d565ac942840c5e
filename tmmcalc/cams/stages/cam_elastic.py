"""Stage ``cam_elastic``: residual and steady vibration of the follower as one mass on an elastic train."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.elastic:solve_elastic"
takes = {"cam_synthesis": "follower"}
kind = ElasticResult
columns = "tmmcalc.cams.elastic:elastic_columns"
declares = ()


def inputs(spec: CamTables) -> CamTask:
    """The motion, the mass, the elastic train."""
    return cam_of(spec, "asked", "loads", "elastic")
