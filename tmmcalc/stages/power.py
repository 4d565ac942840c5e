"""Stage ``power``: work per cycle, efficiency, power, and the motor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.linkage.reduction.results import Reduction
from tmmcalc.machine.model import Gears, MotorChoice
from tmmcalc.machine.power import Power
from tmmcalc.pipeline.stage import Record
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.spec import Spec


def inputs(spec: Spec) -> tuple[MotorChoice | None, Gears]:
    """The motor or the wish for one, and the gears."""
    from tmmcalc.spec.machine import to_gears, to_motor

    return to_motor(spec), to_gears(spec)


def solve(given: tuple[MotorChoice | None, Gears], upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Power:
    """Work and power of the cycle, and how the motor stands to them."""
    from tmmcalc.machine.power import WorkPart, chosen_motor, duty_of, solve_power
    from tmmcalc.stages.shaft import sense

    wish, gears = given
    reduction: Reduction = upstream["reduction"]
    turnover = reduction.cycle.panels.total(np.abs(reduction.parts))
    parts = tuple(
        WorkPart(c.name, c.kind, c.work, float(all_of_it))
        for c, all_of_it in zip(reduction.contributions, turnover, strict=True)
    )
    power = solve_power(reduction.cycle, parts, gears.efficiency, sense(reduction))
    if wish is None:
        return power
    speed = reduction.cycle.speed
    if wish.motor is not None:
        ratio = gears.ratio or wish.motor.speed / speed
        return replace(power, duty=duty_of(power, wish.motor, ratio, (), False, wish.characteristic))
    from tmmcalc.machine.motors.catalogue import load_catalogue
    from tmmcalc.machine.motors.model import with_lag

    choice = chosen_motor(power, wish.catalogue or load_catalogue(), speed, gears.ratio, wish.synchronous)
    motor = with_lag(choice.motor, wish.time_constant)
    ratio = gears.ratio or motor.speed / speed
    return replace(power, duty=duty_of(power, motor, ratio, choice.reasons, True, wish.characteristic))


def dump(result: Power) -> Record:
    """All of it is scalars."""
    return to_record(result, {"work": result.error})


def load(record: Record) -> Power:
    """Build the result from its record."""
    result: Power = from_record(Power, record)
    return result
