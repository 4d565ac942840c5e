"""Stage ``transient``: start-up, braking, run-down and load changes, in time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.machine.model import DriveShaft, FlywheelTask, Gears, MotionTask, MotorChoice, TransientTask
from tmmcalc.machine.transient.columns import timed_columns
from tmmcalc.machine.transient.timed import TimedMotions
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.linkage.reduction.results import Reduction
    from tmmcalc.machine.cycle import Cycle
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.power import MotorDuty
    from tmmcalc.spec import Spec

Given = tuple[
    tuple[TransientTask, ...],
    tuple[DriveShaft, ...],
    MotorChoice | None,
    Gears,
    MotionTask,
    FlywheelTask | None,
]


def inputs(spec: Spec) -> Given:
    """The scenarios, the shafts, the motor, the gears, the constant inertia, a flywheel that is there."""
    from tmmcalc.spec.machine import to_flywheel, to_gears, to_motion, to_motor, to_scenarios, to_shafts

    return (
        to_scenarios(spec),
        to_shafts(spec),
        to_motor(spec),
        to_gears(spec),
        to_motion(spec),
        to_flywheel(spec),
    )


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> TimedMotions:
    """Put the drive together and run every scenario."""
    from tmmcalc.machine.transient.task import Machine, solve_transients
    from tmmcalc.stages.shaft import constant_inertia, driver, flywheel_inertia, mean_speed

    tasks, shafts, wish, gears, motion, wheel = given
    reduction, duty = upstream["reduction"], upstream["power"].duty
    wish = _whole_curve(wish, duty)
    moved = driver(upstream, wish, gears, motion)
    machine = Machine(
        cycle=reduction.cycle,
        idle=_idle(reduction),
        inertia=constant_inertia(upstream, gears, motion, flywheel_inertia(upstream, wheel)),
        motor=_on_motor_shaft(duty, wish, gears),
        reduced=moved.characteristic if moved is not None else None,
        time_constant=moved.time_constant if moved is not None else 0.0,
        ratio=duty.ratio if duty is not None else 1.0,
        shafts=shafts,
        wheel_at_motor=wheel is not None and wheel.shaft == "motor",
    )
    return solve_transients(machine, tasks, mean_speed(upstream, motion))


def _whole_curve(wish: MotorChoice | None, duty: MotorDuty | None) -> MotorChoice | None:
    """The motor by its whole curve: parabola and line hold near the rated speed alone, a start needs more."""
    if (
        wish is None
        or duty is None
        or duty.motor.overload is None
        or wish.characteristic not in ("parabolic", "linear")
    ):
        return wish
    return replace(wish, characteristic="kloss") if duty.motor.kind == "induction" else wish


def _idle(reduction: Reduction) -> Cycle | None:
    """The cycle that a load factor of zero leaves: without technological loads there is nothing to switch off."""
    loads = any(part.kind == "load" for part in reduction.contributions)
    return reduction.idle if loads else reduction.cycle


def _on_motor_shaft(duty: MotorDuty | None, wish: MotorChoice | None, gears: Gears) -> Characteristic | None:
    """The motor on its own shaft, the losses of the gears taken from its moment."""
    if duty is None or wish is None:
        return None
    from tmmcalc.machine.motors.gearing import reduced
    from tmmcalc.machine.motors.model import characteristic

    return reduced(characteristic(duty.motor, wish.characteristic), 1.0, gears.efficiency)


def dump(result: TimedMotions) -> Record:
    """Arrays by the names of the fields, those of the first motion under ``motions.0.``."""
    worst = max((motion.error for motion in result.motions), default=0.0)
    imbalance = max((motion.imbalance for motion in result.motions), default=0.0)
    return to_record(result, {"speed": worst, "energy": imbalance})


def load(record: Record) -> TimedMotions:
    """Build the result from its record."""
    result: TimedMotions = from_record(TimedMotions, record)
    return result


def table(result: TimedMotions) -> Table:
    """All columns, one row a time, one motion after the other."""
    labels = np.concatenate([np.full(len(motion.t), motion.name) for motion in result.motions])
    stacked = zip(*(timed_columns(motion) for motion in result.motions), strict=True)
    columns = [(same[0].header, np.concatenate([column.make() for column in same])) for same in stacked]
    return Table(["motion", *(header for header, _ in columns)], [labels, *(values for _, values in columns)])
