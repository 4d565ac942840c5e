"""Stage ``criteria``: mass, inertia, size and efficiency of all strong trains, and the best of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.core.stage import said
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.tables.tasks.sizing import to_selection
from tmmcalc.gears.wanted import NO_KEPT

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

inputs = to_selection
solve = "tmmcalc.gears.selection.solve:solve_selection"
kind = Selection
columns = "tmmcalc.gears.selection.columns:chosen_columns"
declares = ("K", "front", "rank")
found = "tmmcalc.gears.tables.found:of_criteria"


def errors(result: Selection) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([variant.error for variant in result.variants])


def omits(spec: GearTables) -> tuple[str, ...]:
    """Constraints on trains."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return said((kept_rows(spec, "criteria") is None, NO_KEPT))
