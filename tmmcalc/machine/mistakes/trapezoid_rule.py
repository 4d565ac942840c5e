"""Works are summed up by the trapezoid rule in place of Simpson's (textbook 3.38)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.reduction.other import by_trapezoids, with_works

    found = solve(*given, **upstream)
    return with_works(found, by_trapezoids(found))


MISTAKE = Mistake(
    "works are by the trapezoid rule over the positions",
    "By which rule are the ordinates of the table summed up?",
    SOMETIMES,
    stages={"reduction": _amiss},
)
