"""The profile shifts of the two wheels are swapped (digest 08)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], task: Any, *given: Any, **upstream: Any) -> Any:
    found = solve(task, *given, **upstream)
    swapped = tuple(
        replace(own, strategy="given", refuse=False, shifts=(pair.shifts[1], pair.shifts[0]))
        for own, pair in zip(task.pairs, found.pairs, strict=False)
    )
    return solve(replace(task, pairs=swapped), *given, **upstream)


MISTAKE = Mistake(
    "the profile shifts of the wheels are swapped",
    "Which of the two wheels has which shift?",
    OFTEN,
    stages={"pair": _amiss},
    applies=lambda spec: spec.pair is not None and not spec.pair.of_train,
)
