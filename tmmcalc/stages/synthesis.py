"""Stage ``synthesis``: linkages by what they are to do, each simulated, with their ready specs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.spec import Spec


def inputs(spec: Spec) -> SynthesisTask:
    """What is asked."""
    from tmmcalc.spec.linksyntheses import to_synthesis

    return to_synthesis(spec)


def solve(given: SynthesisTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Synthesis:
    """All solutions that are listed, the best first."""
    from tmmcalc.linkage.synthesis.kinds import solve_synthesis

    return solve_synthesis(given)


def dump(result: Synthesis) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, {"residual": result.residual})


def load(record: Record) -> Synthesis:
    """Build the result from its record."""
    result: Synthesis = from_record(Synthesis, record)
    return result


def table(result: Synthesis) -> Table:
    """One row a solution: its sizes and figures of merit; of a dwell one row a position of the best one."""
    if result.best.dwell is not None:
        from tmmcalc.linkage.synthesis.dwell.columns import columns_of

        motion = result.best.dwell.motion
        listed = columns_of(result.best.dwell)
        return Table(["i", *(c.header for c in listed)], [np.array(motion.labels), *(c.make() for c in listed)])
    from tmmcalc.linkage.synthesis.columns import columns

    found = columns(result)
    return Table(list(found), [np.array(values) for values in found.values()])
