"""The technological loads act in the wrong sense."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, loading: Any, *given: Any, **upstream: Any) -> Any:
    loads = tuple(replace(load, factor=-load.factor) for load in loading.loads)
    return solve(mechanism, replace(loading, loads=loads), *given, **upstream)


MISTAKE = Mistake(
    "the useful resistance acts in the wrong sense",
    "Look at the sense of the useful resistance: does it act against the motion?",
    SOMETIMES,
    stages={"forces": _amiss, "reduction": _amiss},
    applies=lambda spec: spec.mechanism is not None and bool(spec.loads),
)
