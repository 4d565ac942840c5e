"""Stage ``reliability``: reliability of a product whose strength falls under shock loads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.extras.reliability import Reliability, solve_reliability
from tmmcalc.extras.tables.tasks.reliability import to_reliability

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables

inputs = to_reliability
solve = solve_reliability
kind = Reliability
columns = "tmmcalc.extras.columns:reliability_columns"
declares = ()


def packages(spec: ExtraTables) -> tuple[str, ...]:
    """Incomplete gamma functions, and roots."""
    return ("scipy.optimize", "scipy.special")
