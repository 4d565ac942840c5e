"""Stage ``strength``: modules and face widths of all tooth sets by the endurance of their teeth."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.sizing import Sizing, SizingTask
from tmmcalc.gears.tables.tasks.sizing import to_sizing

if TYPE_CHECKING:
    from tmmcalc.gears.trains import Trains

inputs = to_sizing
kind = Sizing
columns = "tmmcalc.gears.strength.columns:stacked"


def solve(task: SizingTask, train: Trains, reduction: Any = None) -> Sizing:
    """Size every set of every variant, for the largest reduced moment where no torque is given."""
    from tmmcalc.gears.sizing import solve_sizing

    return solve_sizing(train, task, None if reduction is None else largest_moment(reduction))


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
