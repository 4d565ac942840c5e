"""Stage ``synthesis``: linkages by what they are to do, each simulated, with their ready specs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.records import record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask

if TYPE_CHECKING:
    from tmmcalc.project import Spec


@record
class Request:
    """A synthesis, and the stages of the scene itself, whose constraints do not concern the designs."""

    task: SynthesisTask
    own: tuple[str, ...] = ()


def inputs(spec: Spec) -> Request:
    """What is asked."""
    from tmmcalc.linkage.synthesis.kinds import SEARCHES
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    task = to_synthesis(spec)
    if task.constraints is None or task.kind not in SEARCHES:
        return Request(task)
    from tmmcalc.pipeline.plan import plan

    return Request(task, plan(spec).running)


def solve(given: Request, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Synthesis:
    """All solutions that are listed, the best first; those of a search that fail constraints are passed over."""
    from tmmcalc.linkage.synthesis.kinds import SEARCHES, solve_synthesis

    constraints, count = given.task.constraints, given.task.solutions
    if constraints is None or given.task.kind not in SEARCHES:
        return solve_synthesis(given.task)
    from tmmcalc.linkage.stages.sifted import SOUGHT, sifted

    found = solve_synthesis(replace(given.task, solutions=max(SOUGHT, count)))
    return sifted(constraints, found, frozenset(given.own), count)


def dump(result: Synthesis) -> Record:
    """Arrays by the names of the fields."""
    sizes = {} if result.error is None else {"sizes": result.error}
    return to_record(result, {"residual": result.residual, **sizes})


def load(record: Record) -> Synthesis:
    """Build the result from its record."""
    result: Synthesis = from_record(Synthesis, record)
    return result


def table(result: Synthesis) -> Table:
    """One row a solution: its sizes and figures of merit; of a dwell one row a position of the best one."""
    if result.best.dwell is not None:
        from tmmcalc.linkage.synthesis.dwell.columns import columns_of

        dwell = result.best.dwell
        listed = columns_of(dwell.motion, dwell.output)
        return Table(
            ["i", *(c.header for c in listed)], Late([np.array(dwell.motion.labels), *(c.make for c in listed)])
        )
    from tmmcalc.linkage.synthesis.columns import columns

    found = columns(result)
    return Table(list(found), [np.array(values) for values in found.values()])
