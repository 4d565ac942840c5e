"""Stage ``transloader``: speeds, loads and stresses of a grab transloader."""

from __future__ import annotations

from typing import Any

from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.transloader import Transloader, solve_transloader

inputs = to_transloader
solve = solve_transloader
kind = Transloader


def errors(result: Transloader) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"numbers": result.error}
