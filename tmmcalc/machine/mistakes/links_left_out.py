"""The energy of the links is left out: J_F = (A_max - A_min)/(delta omega^2) with all of the excess work."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import by_method, of_total
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    return of_total(machine, found, by_method(found, "excess work"))


MISTAKE = Mistake(
    "the changing kinetic energy of the links is left out of the flywheel",
    "What takes up a part of the excess work beside the flywheel?",
    OFTEN,
    stages={"flywheel": _amiss},
)
