"""The excess work is divided by omega and not by its square."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import of_total
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    return of_total(machine, found, found.inertia * machine.speed)


MISTAKE = Mistake(
    "the inertia of the flywheel has omega in place of its square",
    "Look at the power of the mean angular velocity in the formula of the flywheel.",
    SOMETIMES,
    stages={"flywheel": _amiss},
)
