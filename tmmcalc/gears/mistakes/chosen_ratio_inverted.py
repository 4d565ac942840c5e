"""The ratio of the chosen train is inverted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    found = solve(*given, **upstream)
    return replace(found, winner=replace(found.winner, ratio=1 / found.winner.ratio))


MISTAKE = Mistake(
    "the ratio of the train is inverted",
    "Which of the two shafts turns faster, and which speed is over which?",
    SOMETIMES,
    stages={"criteria": _amiss},
)
