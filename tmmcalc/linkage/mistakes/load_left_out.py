"""The technological loads are left out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, loading: Any, *given: Any, **upstream: Any) -> Any:
    return solve(mechanism, replace(loading, loads=()), *given, **upstream)


MISTAKE = Mistake(
    "the useful resistance is left out",
    "Are all given forces there in this position?",
    SOMETIMES,
    stages={"forces": _amiss, "reduction": _amiss},
    applies=lambda spec: spec.mechanism is not None and bool(spec.loads),
)
