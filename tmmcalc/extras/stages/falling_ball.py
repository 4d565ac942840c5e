"""Stage ``falling_ball``: fall of a ball whose radius decreases."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.extras.falling_ball import Ball, BallTask, solve_falling_ball

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> BallTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_ball

    return to_ball(spec)


def solve(given: BallTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Ball:
    """All of it."""
    return solve_falling_ball(given)


def dump(result: Ball) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Ball:
    """Build the result from its record."""
    result: Ball = from_record(Ball, record)
    return result


def table(result: Ball) -> Table:
    """One row a time."""
    from tmmcalc.extras.columns import ball_columns

    columns = ball_columns(result)
    return Table(list(columns), list(columns.values()))
