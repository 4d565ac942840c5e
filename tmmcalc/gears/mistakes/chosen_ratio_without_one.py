"""The ratio of the chosen planetary train is worked out without the 1 (textbook 4.19)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.gears.layouts import LAYOUTS

    found = solve(*given, **upstream)
    layout, winner = LAYOUTS[found.winner.layout], found.winner
    if not layout.planetary or not layout.sign:
        return found
    return replace(found, winner=replace(winner, ratio=layout.sign * (winner.ratio - 1)))


MISTAKE = Mistake(
    "the ratio of the planetary train is worked out without the 1",
    "How does the ratio of a train whose carrier turns follow from the numbers of teeth?",
    OFTEN,
    stages={"criteria": _amiss},
)
