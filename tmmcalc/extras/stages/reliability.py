"""Stage ``reliability``: reliability of a product whose strength falls under shock loads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, plain, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.extras.reliability import Reliability, ReliabilityTask, solve_reliability

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> ReliabilityTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_reliability

    return to_reliability(spec)


def solve(given: ReliabilityTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Reliability:
    """All of it."""
    return solve_reliability(given)


def dump(result: Reliability) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, plain(result.error))


def load(record: Record) -> Reliability:
    """Build the result from its record."""
    result: Reliability = from_record(Reliability, record)
    return result


def table(result: Reliability) -> Table:
    """One row a time."""
    from tmmcalc.extras.columns import reliability_columns

    columns = reliability_columns(result)
    return Table(list(columns), list(columns.values()))
