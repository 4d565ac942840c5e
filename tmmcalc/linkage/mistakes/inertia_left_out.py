"""The inertia of the links is left out of the reactions (textbook 3.1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, loading: Any, *given: Any, **upstream: Any) -> Any:
    return solve(mechanism, replace(loading, inertia="left out"), *given, **upstream)


MISTAKE = Mistake(
    "forces and couples of inertia are left out",
    "The links are accelerated: what does that add to the forces on them?",
    OFTEN,
    stages={"forces": _amiss, "reduction": _amiss},
    applies=lambda spec: spec.mechanism is not None and any(link.mass for link in spec.mechanism.links),
)
