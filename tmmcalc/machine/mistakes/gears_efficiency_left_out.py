"""The efficiency of the gears is left out of the power of the motor."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    found = solve(*given, **upstream)
    return replace(found, motor_power=found.motor_power and found.mean_power)


MISTAKE = Mistake(
    "the efficiency of the gears is left out of the power of the motor",
    "What is lost on the way from the motor to the crank?",
    OFTEN,
    stages={"power": _amiss},
)
