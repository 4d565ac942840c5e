"""Positions are counted from the other extreme position (digest 08, section 3)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, *given: Any, **upstream: Any) -> Any:
    right = solve(mechanism, *given, **upstream)
    start = right.summaries[0].dead_centres[1].x
    return solve(replace(mechanism, input=replace(mechanism.input, start=start)), *given, **upstream)


MISTAKE = Mistake(
    "positions are counted from the other extreme position",
    "From which of the two extreme positions does the task count?",
    OFTEN,
    stages={"kinematics": _amiss},
    applies=lambda spec: spec.mechanism is not None and spec.mechanism.input.start is None,
)
