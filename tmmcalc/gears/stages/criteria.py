"""Stage ``criteria``: mass, inertia, size and efficiency of all strong trains, and the best of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.core.stage import said
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.selection.task import SelectionTask
from tmmcalc.gears.wanted import NO_KEPT

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.sizing import Sizing
    from tmmcalc.gears.trains import Trains

kind = Selection
columns = "tmmcalc.gears.selection.columns:chosen_columns"


def inputs(spec: GearTables) -> SelectionTask:
    """Objectives, weights, the way of choosing, efficiencies of meshes."""
    from tmmcalc.gears.tables.tasks.sizing import to_selection

    return to_selection(spec)


def solve(task: SelectionTask, train: Trains, strength: Sizing) -> Selection:
    """Weigh every train that is strong enough, and choose."""
    from tmmcalc.gears.selection.solve import solve_selection

    return solve_selection(train, strength, task)


def errors(result: Selection) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([variant.error for variant in result.variants])


def omits(spec: GearTables) -> tuple[str, ...]:
    """Constraints on trains."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return said((kept_rows(spec, "criteria") is None, NO_KEPT))
