"""The flywheel is that of the table of positions, whose extremes between the positions are missed (textbook 3.4.2)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import of_total
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    return of_total(machine, found, found.nodal.inertia)


MISTAKE = Mistake(
    "the extremes of the energy are taken at the positions of the table alone",
    "Do the extremes of the excess work lie at the positions of your table?",
    SOMETIMES,
    stages={"flywheel": _amiss},
)
