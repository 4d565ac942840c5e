"""Stage ``flywheel``: the flywheel that keeps the allowed unevenness, by all methods, and its rim."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.machine.flywheel.task import Flywheel
from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.pipeline.stage import Record
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.machine.driver import Driver
    from tmmcalc.spec import Spec

Given = tuple[FlywheelTask, MotorChoice | None, Gears, MotionTask]


def inputs(spec: Spec) -> Given:
    """The flywheel's table, the motor, the gears, the constant inertia."""
    from tmmcalc.spec.machine import to_flywheel, to_gears, to_motion, to_motor

    task = to_flywheel(spec)
    assert task is not None
    return task, to_motor(spec), to_gears(spec), to_motion(spec)


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Flywheel:
    """All methods, and the wheel itself."""
    from tmmcalc.machine.flywheel.task import solve_flywheel
    from tmmcalc.stages.shaft import (
        constant_inertia,
        driver,
        equal_steps,
        geared,
        mean_speed,
        motor_ratio,
        sense,
        shaft_ratio,
    )

    task, wish, gears, motion = given
    gears = geared(upstream, gears)
    at_hand = constant_inertia(upstream, gears, motion)
    reduction, power = upstream["reduction"], upstream["power"]
    if motion.undriven:
        from tmmcalc.machine.selfregulation import undriven_driver

        moved: Driver | None = undriven_driver(reduction.cycle)
    else:
        moved = driver(upstream, wish, gears, motion)
    return solve_flywheel(
        reduction.cycle,
        at_hand,
        task,
        moved,
        mean_speed(upstream, motion),
        shaft_ratio(task, power, gears),
        motor_ratio=motor_ratio(power, gears),
        steps=equal_steps(reduction),
        sense=sense(reduction),
    )


def dump(result: Flywheel) -> Record:
    """Arrays by the names of the fields: the picture and the regime with the flywheel."""
    return to_record(result, {"speed": result.required.regime.error} if result.required is not None else {})


def load(record: Record) -> Flywheel:
    """Build the result from its record."""
    result: Flywheel = from_record(Flywheel, record)
    return result
