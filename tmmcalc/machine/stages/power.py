"""Stage ``power``: work per cycle, efficiency, power, and the motor."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.stage import said
from tmmcalc.machine.power import Power
from tmmcalc.machine.wanted import curved

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.machine.model import Gears, MotorChoice
    from tmmcalc.machine.power import MotorDuty
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.room import MachineTables

kind = Power


NO_MOTOR = "no [motor]: it is not asked for power and speed"
GIVEN_MOTOR = "the motor is given: none is chosen from the catalogue"


Given = tuple["MotorChoice | None", "Gears", str]


def inputs(spec: MachineTables) -> Given:
    """The motor or the wish for one, the gears, and where the spec gives the speed."""
    from tmmcalc.machine.tables.tasks.machine import speed_key, to_gears, to_motor

    return to_motor(spec), to_gears(spec), speed_key(spec)


def solve(
    wish: MotorChoice | None, gears: Gears, key: str, *, reduction: Reduction, criteria: Selection | None = None
) -> Power:
    """Work and power of the cycle, and how the motor stands to them."""
    from tmmcalc.linkage.errors import MARGIN
    from tmmcalc.machine.power import WorkPart, chosen_motor, duty_of, solve_power
    from tmmcalc.machine.reduction.signs import turnover
    from tmmcalc.machine.stages.shaft import geared, sense

    gears = geared(gears, criteria)
    parts = tuple(
        WorkPart(c.name, c.kind, c.work, turnover(reduction.cycle.panels, part), c.error)
        for c, part in zip(reduction.contributions, reduction.parts, strict=True)
    )
    turns = sense(reduction)
    # the margin is for worse places that were not looked at; at one place those of all causes add up by their squares
    rounding = reduction.error.moment / MARGIN * len(parts) ** 0.5
    power = solve_power(reduction.cycle, parts, gears.efficiency, turns, rounding)
    if wish is None:
        return power
    speed = reduction.cycle.speed
    if wish.motor is not None:
        ratio = gears.ratio or wish.motor.speed / speed
        duty = duty_of(power, wish.motor, ratio, (), False, wish.characteristic)
        return replace(power, duty=_told(duty, gears, speed, turns, key))
    from tmmcalc.machine.motors.catalogue import load_catalogue
    from tmmcalc.machine.motors.model import with_lag

    choice = chosen_motor(power, wish.catalogue or load_catalogue(), speed, gears.ratio, wish.synchronous)
    motor = with_lag(choice.motor, wish.time_constant)
    ratio = gears.ratio or motor.speed / speed
    duty = duty_of(power, motor, ratio, choice.reasons, True, wish.characteristic)
    return replace(power, duty=_told(duty, gears, speed, turns, key))


def _told(duty: MotorDuty, gears: Gears, speed: float, turns: float, key: str) -> MotorDuty:
    """The duty with whose ratio it has, and how far the motor misses the speed of the spec."""
    from tmmcalc.machine.offspeed import off_rated

    return replace(duty, ratio_of=gears.ratio_of, off_speed=off_rated(duty.motor.speed, duty.ratio, speed, turns, key))


def omits(spec: MachineTables) -> tuple[str, ...]:
    """What is not asked of a motor."""
    from tmmcalc.machine.tables.tasks.machine import CHOOSE

    motor = spec.motor
    return said((motor is None, NO_MOTOR), (motor is not None and motor.name != CHOOSE, GIVEN_MOTOR))


def packages(spec: MachineTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a motor."""
    return curved(spec)
