"""Stage ``strength``: modules and face widths of all tooth sets by the endurance of their teeth."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.sizing import Sizing, SizingTask

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> SizingTask:
    """The torque or where it comes from, materials, rules of rounding."""
    from tmmcalc.gears.tables.tasks.sizing import to_sizing

    return to_sizing(spec)


def solve(given: SizingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Sizing:
    """Size every set of every variant, for the largest reduced moment where no torque is given."""
    from tmmcalc.gears.sizing import solve_sizing

    reduction = upstream.get("reduction")
    return solve_sizing(upstream["train"], given, None if reduction is None else largest_moment(reduction))


def largest_moment(reduction: Any) -> float:
    """max|M_c| over the cycle [N*m] of the result of the stage ``reduction``.

    Raises `UsageError` for a driven slider, on which forces act.
    """
    if not reduction.turns:
        raise UsageError(
            "the input is a driven slider: there is no moment on a crank",
            where="strength",
            remedy="give torque, or moment and moment_ratio",
        )
    least, largest = reduction.cycle.panels.extremes(reduction.parts.sum(axis=0))
    return float(max(abs(least[0]), abs(largest[0])))


def errors(result: Sizing) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([variant.error for variant in result.variants])


def columns(result: Sizing) -> Mapping[str, Any]:
    """All sized sets, one row a set, one variant after the other."""
    from tmmcalc.gears.strength.columns import stacked

    return stacked(result)
