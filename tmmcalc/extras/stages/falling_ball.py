"""Stage ``falling_ball``: fall of a ball whose radius decreases."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.extras.falling_ball import Ball, BallTask, solve_falling_ball

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables


def inputs(spec: ExtraTables) -> BallTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_ball

    return to_ball(spec)


def solve(given: BallTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Ball:
    """All of it."""
    return solve_falling_ball(given)


def columns(result: Ball) -> Mapping[str, Any]:
    """One row a time."""
    from tmmcalc.extras.columns import ball_columns

    return ball_columns(result)


def packages(spec: ExtraTables) -> tuple[str, ...]:
    """Bessel functions, and roots."""
    return ("scipy.optimize", "scipy.special")
