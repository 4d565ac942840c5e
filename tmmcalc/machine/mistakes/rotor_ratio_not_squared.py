"""The inertia of the rotor is brought to the crank by u and not by u^2."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    found = solve(*given, **upstream)
    return found and replace(
        found, duty=found.duty and replace(found.duty, rotor=found.duty.rotor / abs(found.duty.ratio))
    )


MISTAKE = Mistake(
    "the inertia of the rotor is brought to the crank by u in place of u^2",
    "By which power of the ratio does a moment of inertia go from one shaft to another?",
    OFTEN,
    stages={"power": _amiss},
)
