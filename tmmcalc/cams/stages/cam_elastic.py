"""Stage ``cam_elastic``: residual and steady vibration of the follower as one mass on an elastic train."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.machine.motion import Motion

kind = ElasticResult
columns = "tmmcalc.cams.elastic:elastic_columns"


def inputs(spec: CamTables) -> CamTask:
    """The motion, the mass, the elastic train."""
    return cam_of(spec, "asked", "loads", "elastic")


def solve(task: CamTask, cam_synthesis: Synthesis, motion: Motion | None = None) -> ElasticResult:
    """The vibration over the turn, at the speed of the machine if it is known."""
    from tmmcalc.cams.elastic import solve_elastic

    return solve_elastic(at_speed(task, motion), cam_synthesis.follower)
