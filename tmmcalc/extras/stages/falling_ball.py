"""Stage ``falling_ball``: fall of a ball whose radius decreases."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.extras.falling_ball import Ball, solve_falling_ball
from tmmcalc.extras.tables.tasks.falling_ball import to_ball

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables

inputs = to_ball
solve = solve_falling_ball
kind = Ball
columns = "tmmcalc.extras.columns:ball_columns"
declares = ()


def packages(spec: ExtraTables) -> tuple[str, ...]:
    """Bessel functions, and roots."""
    return ("scipy.optimize", "scipy.special")
