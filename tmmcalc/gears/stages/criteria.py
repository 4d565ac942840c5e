"""Stage ``criteria``: mass, inertia, size and efficiency of all strong trains, and the best of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.core.stage import said
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.selection.task import SelectionTask
from tmmcalc.gears.wanted import NO_KEPT

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> SelectionTask:
    """Objectives, weights, the way of choosing, efficiencies of meshes."""
    from tmmcalc.gears.tables.tasks.sizing import to_selection

    return to_selection(spec)


def solve(given: SelectionTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Selection:
    """Weigh every train that is strong enough, and choose."""
    from tmmcalc.gears.selection.solve import solve_selection

    return solve_selection(upstream["train"], upstream["strength"], given)


def errors(result: Selection) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([variant.error for variant in result.variants])


def columns(result: Selection) -> Mapping[str, Any]:
    """All trains, one a row, one variant after the other."""
    from tmmcalc.gears.selection.columns import chosen_columns

    return chosen_columns(result)


def omits(spec: GearTables) -> tuple[str, ...]:
    """Constraints on trains."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return said((kept_rows(spec, "criteria") is None, NO_KEPT))
