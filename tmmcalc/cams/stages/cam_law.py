"""Stage ``cam_law``: the law of motion of the follower over the turn of the cam."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.stages.parts import cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> CamTask:
    """Phases, laws, the rows of the table, the speed."""
    return cam_of(spec)


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> LawResult:
    """Displacement and its derivatives at all rows; what the laws cost."""
    from tmmcalc.cams.lawresult import solve_law

    return solve_law(given)


def dump(result: LawResult) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> LawResult:
    """Build the result from its record."""
    result: LawResult = from_record(LawResult, record)
    return result


def table(result: LawResult) -> Table:
    """One row a position."""
    from tmmcalc.cams.lawresult import law_columns

    columns = law_columns(result)
    return Table(list(columns), list(columns.values()))
