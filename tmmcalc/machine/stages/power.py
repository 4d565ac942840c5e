"""Stage ``power``: work per cycle, efficiency, power, and the motor."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.stage import said
from tmmcalc.machine.power import Power
from tmmcalc.machine.wanted import curved

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.machine.driveline import DriveLine
    from tmmcalc.machine.model import Gears, MotorChoice, TrialTask
    from tmmcalc.machine.power import MotorDuty
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.settled import MotorFound, Settled

kind = Power


NO_MOTOR = "no [motor]: it is not asked for power and speed"
GIVEN_MOTOR = "the motor is given: none is chosen from the catalogue"


Given = tuple["MotorChoice | None", "Gears", str, "TrialTask | None"]


def inputs(spec: MachineTables) -> Given:
    """The motor or the wish for one, the gears, where the spec gives the speed, what a motor is tried by."""
    from tmmcalc.machine.tables.tasks.machine import speed_key, to_gears, to_motor, to_trial

    return to_motor(spec), to_gears(spec), speed_key(spec), to_trial(spec)


def solve(
    wish: MotorChoice | None,
    gears: Gears,
    key: str,
    trial: TrialTask | None = None,
    *,
    reduction: Reduction,
    criteria: Selection | None = None,
    drive: Settled | None = None,
) -> Power:
    """Work and power of the cycle, and how the motor stands to them."""
    from tmmcalc.machine.driveline import drive_line
    from tmmcalc.machine.motors.model import with_lag
    from tmmcalc.machine.power import duty_of
    from tmmcalc.machine.stages.shaft import sense

    power = power_of(reduction, drive_line(gears, None if criteria is None else criteria.winner))
    if wish is None:
        return power
    speed = reduction.cycle.speed
    found = None if trial is None else _chosen(power, reduction, wish, trial, drive)
    motor = wish.motor if found is None else with_lag(found.motor, wish.time_constant)
    assert motor is not None
    ratio = power.line.ratio or motor.speed / speed
    reasons = () if found is None else found.reasons
    duty = duty_of(power, motor, ratio, reasons, found is not None, wish.characteristic)
    if found is not None:
        duty = replace(duty, judged=found.judged, taken=found.taken)
    if drive is not None:
        duty = replace(duty, rounds=drive.rounds, in_turn=drive.alternating)
    return replace(power, duty=_told(duty, power.line, speed, sense(reduction), key))


def _chosen(
    power: Power, reduction: Reduction, wish: MotorChoice, trial: TrialTask, drive: Settled | None
) -> MotorFound:
    """The motor that is chosen here, or was with the ratio of the train: that is judged again with the train itself."""
    from tmmcalc.machine.stages.trial import ChosenMotor, judge_motor

    found = None if drive is None else drive.found
    if found is None:
        return ChosenMotor(power, reduction, wish, trial).told()
    own = judge_motor(power, reduction, wish, trial, found.motor)
    return replace(found, judged=(*(each for each in found.judged if each.motor != own.motor), own))


def power_of(reduction: Reduction, line: DriveLine) -> Power:
    """Work and power of the cycle, without a motor."""
    from tmmcalc.linkage.errors import MARGIN
    from tmmcalc.machine.power import WorkPart, solve_power
    from tmmcalc.machine.reduction.signs import turnovers
    from tmmcalc.machine.stages.shaft import sense

    moved = turnovers(reduction.cycle.panels, reduction.parts)
    parts = tuple(
        WorkPart(c.name, c.kind, c.work, work, c.error) for c, work in zip(reduction.contributions, moved, strict=True)
    )
    # the margin is for worse places that were not looked at; at one place those of all causes add up by their squares
    rounding = reduction.error.moment / MARGIN * len(parts) ** 0.5
    return solve_power(reduction.cycle, parts, line, sense(reduction), rounding)


def _told(duty: MotorDuty, line: DriveLine, speed: float, turns: float, key: str) -> MotorDuty:
    """The duty with whose ratio it has, and how far the motor misses the speed of the spec."""
    from tmmcalc.machine.offspeed import off_rated

    return replace(duty, ratio_of=line.ratio_of, off_speed=off_rated(duty.motor.speed, duty.ratio, speed, turns, key))


def omits(spec: MachineTables) -> tuple[str, ...]:
    """What is not asked of a motor."""
    from tmmcalc.machine.tables.tasks.machine import CHOOSE

    motor = spec.motor
    return said((motor is None, NO_MOTOR), (motor is not None and motor.name != CHOOSE, GIVEN_MOTOR))


def packages(spec: MachineTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a motor."""
    return curved(spec)
