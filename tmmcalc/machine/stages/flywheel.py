"""Stage ``flywheel``: the flywheel that keeps the allowed unevenness, by all methods, and its rim."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.core.stage import said
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine
from tmmcalc.machine.model import FlywheelTask, MotionTask, MotorChoice
from tmmcalc.machine.wanted import NO_REGIME, constant_moment, curved

if TYPE_CHECKING:
    from tmmcalc.machine.driver import ConstantInertia, Driver
    from tmmcalc.machine.flywheel.worked import Paper, Worked
    from tmmcalc.machine.room import MachineTables


kind = Flywheel
solve = "tmmcalc.machine.flywheel.solve:solve_flywheel"
found = "tmmcalc.machine.tables.found:of_flywheel"


class Asked(NamedTuple):
    """What a flywheel is for: the constant inertia at hand, what drives, the mean speed without a motor [rad/s]."""

    at_hand: ConstantInertia
    driver: Driver | None
    speed: float


Given = tuple[FlywheelTask, MotorChoice | None, MotionTask]


def inputs(spec: MachineTables) -> Given:
    """The flywheel's table, the motor, the constant inertia."""
    from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_motion, to_motor

    task = to_flywheel(spec)
    assert task is not None
    return task, to_motor(spec), to_motion(spec)


def task(*given: *Given, **upstream: Any) -> Machine:
    """The machine without a flywheel, and what is asked of one."""
    from tmmcalc.machine.stages.shaft import equal_steps, motor_ratio, sense, shaft_ratio

    wheel, machine = given[0], asked(given, upstream)
    reduction, power = upstream["reduction"], upstream["power"]
    return Machine(
        reduction.cycle,
        machine.at_hand,
        wheel,
        machine.driver,
        machine.speed,
        shaft_ratio(wheel, power),
        motor_ratio(power),
        equal_steps(reduction),
        sense(reduction),
    )


def asked(given: Given, upstream: Mapping[str, Any]) -> Asked:
    """The machine with the drive line that earlier stages found, without a flywheel."""
    from tmmcalc.machine.stages.shaft import constant_inertia, driver, mean_speed

    _, wish, motion = given
    if motion.undriven:
        from tmmcalc.machine.selfregulation import undriven_driver

        moved: Driver | None = undriven_driver(upstream["reduction"].cycle)
    else:
        moved = driver(upstream, wish, motion)
    return Asked(constant_inertia(upstream, motion), moved, mean_speed(upstream, motion))


def errors(result: Flywheel) -> dict[str, Any]:
    """Estimates of its errors."""
    errors = {"inertia": result.error, "fluctuation": result.uneven}
    if result.required is not None:
        errors["speed"] = result.required.regime.error
    return errors


def details(spec: MachineTables, results: Mapping[str, Any]) -> Mapping[str, Paper | Worked]:
    """Facts by choice: Wittenbauer's tangents on paper, and what every method works out on its way."""
    from tmmcalc.machine.flywheel.worked import paper, round_scales

    result: Flywheel = results["flywheel"]
    methods = {each.key: each for each in methods_of(spec, results)}
    return {"tangents": paper(result.picture, round_scales(result.picture), result.sense), **methods}


def methods_of(spec: MachineTables, results: Mapping[str, Any]) -> tuple[Worked, ...]:
    """What every method works out on its way, on the whole cycle and on the positions."""
    from tmmcalc.machine.flywheel.worked import worked
    from tmmcalc.machine.stages.shaft import equal_steps, sense

    result, reduction = results["flywheel"], results["reduction"]
    speed, steps = mean(spec, results), equal_steps(reduction)
    return worked(reduction.cycle, result.delta, speed, steps, sense(reduction))


def mean(spec: MachineTables, results: Mapping[str, Any]) -> float:
    """The mean speed that all methods assume [rad/s]: under a motor that with the flywheel that is needed."""
    result: Flywheel = results["flywheel"]
    return result.required.regime.mean if result.required is not None else asked(inputs(spec), results).speed


def omits(spec: MachineTables) -> tuple[str, ...]:
    """The regime of a motor that the machine has not."""
    return said((constant_moment(spec), NO_REGIME))


def packages(spec: MachineTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a motor."""
    return curved(spec)
