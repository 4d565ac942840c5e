"""The work of half a cycle is taken for that of a whole one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.reduction.other import over_half, with_works

    found = solve(*given, **upstream)
    return with_works(found, over_half(found))


MISTAKE = Mistake(
    "the work of half a cycle is taken",
    "Over which part of the motion is the work of a cycle summed up?",
    SOMETIMES,
    stages={"reduction": _amiss},
)
