"""Stage ``bearing``: speeds and frequencies of the defects of a rolling bearing."""

from __future__ import annotations

from typing import Any

from tmmcalc.extras.bearing import Bearing, solve_bearing
from tmmcalc.extras.tables.tasks.bearing import to_bearing

inputs = to_bearing
solve = solve_bearing
kind = Bearing


def errors(result: Bearing) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"frequencies": result.error}
