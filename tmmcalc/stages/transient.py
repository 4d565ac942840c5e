"""Stage ``transient``: start-up, braking, run-down and load changes, in time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.machine.model import DriveShaft, FlywheelTask, Gears, MotionTask, MotorChoice, TransientTask
from tmmcalc.machine.transient.columns import timed_columns
from tmmcalc.machine.transient.timed import TimedMotions
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
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
    from tmmcalc.machine.motors.model import characteristic
    from tmmcalc.machine.transient.task import Machine, solve_transients
    from tmmcalc.stages.shaft import constant_inertia, driver, flywheel_inertia

    tasks, shafts, wish, gears, motion, wheel = given
    reduction, duty = upstream["reduction"], upstream["power"].duty
    moved = driver(upstream, wish, gears, motion)
    machine = Machine(
        cycle=reduction.cycle,
        idle=reduction.idle,
        inertia=constant_inertia(upstream, gears, motion, flywheel_inertia(upstream, wheel)),
        motor=characteristic(duty.motor, wish.characteristic) if duty is not None and wish is not None else None,
        reduced=moved.characteristic if moved is not None else None,
        time_constant=moved.time_constant if moved is not None else 0.0,
        ratio=duty.ratio if duty is not None else 1.0,
        shafts=shafts,
        wheel_at_motor=wheel is not None and wheel.shaft == "motor",
    )
    steady = upstream.get("motion")
    return solve_transients(machine, tasks, float(steady.omega[0]) if steady is not None else None)


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
