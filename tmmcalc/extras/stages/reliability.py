"""Stage ``reliability``: reliability of a product whose strength falls under shock loads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.extras.reliability import Reliability, ReliabilityTask, solve_reliability

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables


def inputs(spec: ExtraTables) -> ReliabilityTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_reliability

    return to_reliability(spec)


def solve(given: ReliabilityTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Reliability:
    """All of it."""
    return solve_reliability(given)


def columns(result: Reliability) -> Mapping[str, Any]:
    """One row a time."""
    from tmmcalc.extras.columns import reliability_columns

    return reliability_columns(result)


def packages(spec: ExtraTables) -> tuple[str, ...]:
    """Incomplete gamma functions, and roots."""
    return ("scipy.optimize", "scipy.special")
