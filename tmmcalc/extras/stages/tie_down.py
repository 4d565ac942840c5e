"""Stage ``tie_down``: forces in the ties of a transported load."""

from __future__ import annotations

from typing import Any

from tmmcalc.extras.tables.tasks.tie_down import to_tie_down
from tmmcalc.extras.tie_down import TieDown, solve_tie_down

inputs = to_tie_down
solve = solve_tie_down
kind = TieDown
columns = "tmmcalc.extras.columns:tie_down_columns"
declares = ()


def errors(result: TieDown) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"forces": result.error}
