"""Stage ``train``: the tooth numbers of the gear train, one variant a layout and number of planets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import said
from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows
from tmmcalc.gears.trains import Asked, Trains
from tmmcalc.gears.wanted import NO_KEPT, ratio_of_drive

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

solve = "tmmcalc.gears.train:solve_train"
kind = Trains
columns = "tmmcalc.gears.columns:stacked"
declares = ("layout", "planets", "u", "i_{ratio}")
details = "tmmcalc.gears.details:of_train"
found = "tmmcalc.gears.tables.found:of_train"


def inputs(spec: GearTables) -> Asked:
    """What is asked of every layout: ratios, limits and tolerances as exact fractions; constraints on tooth sets."""
    from tmmcalc.gears.tables.tasks.train import to_train

    return Asked(to_train(spec), kept_rows(spec, "train"), ratio_of_drive(spec))


def errors(result: Trains) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"ratio": 0.0, "angles": max(variant.error for variant in result.variants)}


def omits(spec: GearTables) -> tuple[str, ...]:
    """Constraints on tooth sets."""
    return said((kept_rows(spec, "train") is None, NO_KEPT))
