"""Stage ``tie_down``: forces in the ties of a transported load."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.extras.tie_down import TieDown, TieDownTask, solve_tie_down

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables


def inputs(spec: ExtraTables) -> TieDownTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_tie_down

    return to_tie_down(spec)


def solve(given: TieDownTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> TieDown:
    """All of it."""
    return solve_tie_down(given)


def errors(result: TieDown) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"forces": result.error}
