"""The inertia of the rotor is not brought to the crank."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    found = solve(*given, **upstream)
    return found and replace(found, duty=found.duty and replace(found.duty, rotor=found.duty.motor.inertia or 0.0))


MISTAKE = Mistake(
    "the inertia of the rotor is not brought to the crank",
    "On which shaft does the rotor turn, and how fast against the crank?",
    SOMETIMES,
    stages={"power": _amiss},
)
