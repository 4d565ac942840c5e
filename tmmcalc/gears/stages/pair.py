"""Stage ``pair``: geometry, checks and measures of pairs of gears, written out or those of the chosen train."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.task import PairsTask

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> PairsTask:
    """Teeth, racks, the choice of shifts, limits, what is measured."""
    from tmmcalc.gears.tables.tasks.pair import to_pairs

    return to_pairs(spec)


def solve(given: PairsTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Pairs:
    """Every pair."""
    from tmmcalc.gears.meshing.solve import solve_pairs

    return solve_pairs(given, upstream.get("criteria"))


def errors(result: Pairs) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([pair.error for pair in result.pairs])


def columns(result: Pairs) -> Mapping[str, Any]:
    """Sliding and pressure along the line of action, one pair after the other."""
    from tmmcalc.gears.meshing.columns import pair_columns

    return pair_columns(result)
