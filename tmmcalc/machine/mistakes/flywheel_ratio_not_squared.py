"""The inertia of the flywheel is brought to its own shaft by u and not by u^2."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import of_own
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    return of_own(machine, found, found.addition / abs(machine.ratio))


MISTAKE = Mistake(
    "the inertia of the flywheel is brought to its shaft by u in place of u^2",
    "By which power of the ratio does a moment of inertia go from one shaft to another?",
    OFTEN,
    stages={"flywheel": _amiss},
)
