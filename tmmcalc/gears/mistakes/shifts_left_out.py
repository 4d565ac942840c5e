"""The profile shifts are left out: both wheels are cut without."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], task: Any, *given: Any, **upstream: Any) -> Any:
    plain = tuple(replace(own, strategy="given", refuse=False, shifts=(0.0, 0.0)) for own in task.pairs)
    return solve(replace(task, pairs=plain), *given, **upstream)


MISTAKE = Mistake(
    "the profile shifts are left out",
    "Are these wheels cut with shifts?",
    SOMETIMES,
    stages={"pair": _amiss},
    applies=lambda spec: spec.pair is not None and not spec.pair.of_train,
)
