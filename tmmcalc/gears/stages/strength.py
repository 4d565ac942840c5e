"""Stage ``strength``: modules and face widths of all tooth sets by the endurance of their teeth."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.conversion import largest
from tmmcalc.gears.sizing import Sizing
from tmmcalc.gears.tables.tasks.sizing import to_sizing

inputs = to_sizing
solve = "tmmcalc.gears.sizing:solve_sizing"
kind = Sizing
columns = "tmmcalc.gears.strength.columns:stacked"
declares = ("layout", "K", "outcome")
details = "tmmcalc.gears.details:of_strength"


def errors(result: Sizing) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([variant.error for variant in result.variants])
