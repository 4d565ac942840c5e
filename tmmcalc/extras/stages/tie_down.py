"""Stage ``tie_down``: forces in the ties of a transported load."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record
from tmmcalc.extras.tie_down import TieDown, TieDownTask, solve_tie_down

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> TieDownTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_tie_down

    return to_tie_down(spec)


def solve(given: TieDownTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> TieDown:
    """All of it."""
    return solve_tie_down(given)


def dump(result: TieDown) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, {"forces": result.error})


def load(record: Record) -> TieDown:
    """Build the result from its record."""
    result: TieDown = from_record(TieDown, record)
    return result
