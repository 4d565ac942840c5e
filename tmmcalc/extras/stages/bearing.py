"""Stage ``bearing``: speeds and frequencies of the defects of a rolling bearing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.extras.bearing import Bearing, BearingTask, solve_bearing

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables


def inputs(spec: ExtraTables) -> BearingTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_bearing

    return to_bearing(spec)


def solve(given: BearingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Bearing:
    """All of it."""
    return solve_bearing(given)


def errors(result: Bearing) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"frequencies": result.error}
