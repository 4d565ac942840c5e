"""The profile shifts of the two wheels are swapped."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.gears.meshing.reshifted import with_shifts

    found = solve(*given, **upstream)
    return with_shifts(found, [(second, first) for first, second in (pair.shifts for pair in found.pairs)])


MISTAKE = Mistake(
    "the profile shifts of the wheels are swapped",
    "Which of the two wheels has which shift?",
    OFTEN,
    stages={"pair": _amiss},
)
