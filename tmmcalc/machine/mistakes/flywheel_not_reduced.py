"""The inertia of the flywheel is not brought to its own shaft."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import of_own
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    return of_own(machine, found, found.addition)


MISTAKE = Mistake(
    "the inertia of the flywheel is not brought to the shaft it stands on",
    "On which shaft does the flywheel stand, and for which one is your value?",
    OFTEN,
    stages={"flywheel": _amiss},
)
