"""Stage ``cam_synthesis``: sizes of the cam and its follower, given or found under the limits of the pressure angle."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """The motion, sizes that are given, limits of pressure angle and radii."""
    return cam_of(spec, "asked", "limits")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Synthesis:
    """Every size, by the textbook and exactly."""
    from tmmcalc.cams.synthesis.solve import solve_synthesis

    return solve_synthesis(given)


def dump(result: Synthesis) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Synthesis:
    """Build the result from its record."""
    result: Synthesis = from_record(Synthesis, record)
    return result
