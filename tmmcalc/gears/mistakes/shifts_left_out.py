"""The profile shifts are left out: both wheels are cut without."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.gears.meshing.reshifted import with_shifts

    found = solve(*given, **upstream)
    return with_shifts(found, [(0.0, 0.0)] * len(found.pairs))


MISTAKE = Mistake(
    "the profile shifts are left out",
    "Are these wheels cut with shifts?",
    SOMETIMES,
    stages={"pair": _amiss},
)
