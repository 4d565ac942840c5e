"""Normal accelerations of relative motion are left out, the tangential ones alone are there (textbook 2.8.1)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.linkage.results import Terms

    return solve(*given, **upstream, terms=Terms(normal=0.0))


MISTAKE = Mistake(
    "the normal accelerations of the links are left out, the tangential ones alone are taken",
    "Look at the acceleration of one point of a link about another: has it one part or two?",
    OFTEN,
    stages={"kinematics": _amiss},
)
