"""Stage ``bearing``: speeds and frequencies of the defects of a rolling bearing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record
from tmmcalc.extras.bearing import Bearing, BearingTask, solve_bearing

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> BearingTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_bearing

    return to_bearing(spec)


def solve(given: BearingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Bearing:
    """All of it."""
    return solve_bearing(given)


def dump(result: Bearing) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, {"frequencies": result.error})


def load(record: Record) -> Bearing:
    """Build the result from its record."""
    result: Bearing = from_record(Bearing, record)
    return result
