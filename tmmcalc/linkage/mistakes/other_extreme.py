"""Positions are counted from the other extreme position."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, *given: Any, **upstream: Any) -> Any:
    right = solve(mechanism, *given, **upstream)
    start = right.summaries[0].dead_centres[1].x
    return solve(replace(mechanism, input=replace(mechanism.input, start=start)), *given, **upstream)


def _counted_from_one(spec: Any) -> bool:
    """Whether position 0 is an extreme position."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return spec.mechanism is not None and to_linkage(spec.linkage).input.start is None


MISTAKE = Mistake(
    "positions are counted from the other extreme position",
    "From which of the two extreme positions does the task count?",
    OFTEN,
    stages={"kinematics": _amiss},
    applies=_counted_from_one,
)
