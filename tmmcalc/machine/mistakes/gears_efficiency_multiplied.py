"""The power of the motor is multiplied by the efficiency of the gears and not divided by it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    found = solve(*given, **upstream)
    return replace(found, motor_power=found.motor_power and found.mean_power * found.line.efficiency)


MISTAKE = Mistake(
    "the power of the motor is multiplied by the efficiency and not divided",
    "Has the motor to give more than the crank takes, or less?",
    SOMETIMES,
    stages={"power": _amiss},
)
