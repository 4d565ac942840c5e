"""Stage ``flywheel``: the flywheel that keeps the allowed unevenness, by all methods, and its rim."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.core.stage import said
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine, flywheel_of, solve_flywheel
from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.machine.wanted import NO_REGIME, constant_moment, curved

if TYPE_CHECKING:
    from tmmcalc.machine.driver import ConstantInertia, Driver
    from tmmcalc.machine.flywheel.results import Comparison, Trial
    from tmmcalc.machine.room import MachineTables


kind = Flywheel


class Asked(NamedTuple):
    """What a flywheel is for: the constant inertia at hand, what drives, the mean speed without a motor [rad/s]."""

    at_hand: ConstantInertia
    driver: Driver | None
    speed: float


Given = tuple[FlywheelTask, MotorChoice | None, Gears, MotionTask]


def inputs(spec: MachineTables) -> Given:
    """The flywheel's table, the motor, the gears, the constant inertia."""
    from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_gears, to_motion, to_motor

    task = to_flywheel(spec)
    assert task is not None
    return task, to_motor(spec), to_gears(spec), to_motion(spec)


def solve(*given: *Given, **upstream: Any) -> Flywheel:
    """All methods, and the wheel itself."""
    return solve_flywheel(_machine(given, upstream))


def of_searches(
    given: Given, upstream: Mapping[str, Any], comparison: Comparison, history: tuple[Trial, ...]
) -> Flywheel:
    """The same from what all methods lead to, where that is known."""
    return flywheel_of(_machine(given, upstream), comparison, history)


def _machine(given: Given, upstream: Mapping[str, Any]) -> Machine:
    from tmmcalc.machine.stages.shaft import equal_steps, geared, motor_ratio, sense, shaft_ratio

    task, machine = given[0], asked(given, upstream)
    gears = geared(given[2], upstream.get("criteria"))
    reduction, power = upstream["reduction"], upstream["power"]
    return Machine(
        reduction.cycle,
        machine.at_hand,
        task,
        machine.driver,
        machine.speed,
        shaft_ratio(task, power, gears),
        motor_ratio(power, gears),
        equal_steps(reduction),
        sense(reduction),
    )


def asked(given: Given, upstream: Mapping[str, Any]) -> Asked:
    """The machine with the gears that earlier stages found, without a flywheel."""
    from tmmcalc.machine.stages.shaft import constant_inertia, driver, geared, mean_speed

    _, wish, gears, motion = given
    gears = geared(gears, upstream.get("criteria"))
    if motion.undriven:
        from tmmcalc.machine.selfregulation import undriven_driver

        moved: Driver | None = undriven_driver(upstream["reduction"].cycle)
    else:
        moved = driver(upstream, wish, gears, motion)
    return Asked(constant_inertia(upstream, gears, motion), moved, mean_speed(upstream, motion))


def errors(result: Flywheel) -> dict[str, Any]:
    """Estimates of its errors."""
    errors = {"inertia": result.error, "fluctuation": result.uneven}
    if result.required is not None:
        errors["speed"] = result.required.regime.error
    return errors


def omits(spec: MachineTables) -> tuple[str, ...]:
    """The regime of a motor that the machine has not."""
    return said((constant_moment(spec), NO_REGIME))


def packages(spec: MachineTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a motor."""
    return curved(spec)
