"""The constant inertia at hand, of rotor and gears, is not taken off: the flywheel is the whole J_F."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.machine.flywheel.other import of_total
    from tmmcalc.machine.stages.flywheel import task

    less = {key: upstream[key] for key in ("reduction", "power")}
    found, machine = solve(*given, **upstream), task(*given, **less)
    other = of_total(machine, found, found.inertia + machine.at_hand.total)
    return replace(other, inertia=found.inertia)


MISTAKE = Mistake(
    "the inertia of rotor and gears that is at hand is not taken off the flywheel",
    "Which masses turn at a constant ratio to the crank already, without the flywheel?",
    OFTEN,
    stages={"flywheel": _amiss},
)
