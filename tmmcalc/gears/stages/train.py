"""Stage ``train``: the tooth numbers of the gear train, one variant a layout and number of planets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record
from tmmcalc.core.stage import said
from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows
from tmmcalc.gears.trains import Request, Trains
from tmmcalc.gears.wanted import NO_KEPT

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.gears.room import GearTables

kind = Trains
columns = "tmmcalc.gears.columns:stacked"


@record
class Asked:
    """What is asked of every layout, and the user's constraints on tooth sets, if there are any."""

    requests: tuple[Request, ...]
    kept: FeasibilityTask | None = None


def inputs(spec: GearTables) -> Asked:
    """What is asked of every layout: ratios, limits and tolerances as exact fractions; constraints on tooth sets."""
    from tmmcalc.gears.tables.tasks.train import to_train

    return Asked(to_train(spec), kept_rows(spec, "train"))


def solve(given: Asked) -> Trains:
    """All tooth sets of every variant that keep the user's constraints."""
    from tmmcalc.core.progress import tell
    from tmmcalc.gears.train import solve_train

    found = solve_train(given.requests, tell)
    if given.kept is None:
        return found
    from tmmcalc.gears.userconstraints import kept_sets

    return kept_sets(found, given.kept)


def errors(result: Trains) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"ratio": 0.0, "angles": max(variant.error for variant in result.variants)}


def omits(spec: GearTables) -> tuple[str, ...]:
    """Constraints on tooth sets."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return said((kept_rows(spec, "train") is None, NO_KEPT))
