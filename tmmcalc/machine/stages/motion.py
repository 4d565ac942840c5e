"""Stage ``motion``: the steady motion of the machine with its motor and flywheel."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmmcalc.core.conversion import from_record, plain, to_record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.machine.columns import motion_columns
from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.machine.motion import Motion

if TYPE_CHECKING:
    from tmmcalc.machine.driver import ConstantInertia, Driver
    from tmmcalc.project import Spec


class Asked(NamedTuple):
    """What the regime is of: the constant inertia, what drives, the mean speed where nothing does [rad/s]."""

    inertia: ConstantInertia
    driver: Driver | None
    speed: float


Given = tuple[MotorChoice | None, Gears, MotionTask, FlywheelTask | None, str]


def inputs(spec: Spec) -> Given:
    """The motor, the gears, the constant inertia, a flywheel that is there, where the spec gives the speed."""
    from tmmcalc.machine.tables.tasks.machine import speed_key, to_flywheel, to_gears, to_motion, to_motor

    return to_motor(spec), to_gears(spec), to_motion(spec), to_flywheel(spec), speed_key(spec)


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Motion:
    """The regime with the flywheel that is there, or else the one that was found."""
    from tmmcalc.machine.motion import solve_motion

    machine = asked(given, upstream)
    reduction = upstream["reduction"]
    theta = np.abs(reduction.phi - reduction.phi[0])
    return solve_motion(
        reduction.cycle,
        reduction.idle,
        machine.inertia,
        machine.driver,
        machine.speed,
        (reduction.labels, reduction.phi, theta),
        given[4],
        undriven=given[2].undriven,
        tolerance=settings["tolerance"],
    )


def asked(given: Given, upstream: Mapping[str, Any]) -> Asked:
    """The machine with the gears and the flywheel that earlier stages found."""
    from tmmcalc.machine.stages.shaft import constant_inertia, driver, flywheel_inertia, geared, mean_speed

    wish, gears, task, wheel, _ = given
    gears = geared(upstream, gears)
    inertia = constant_inertia(upstream, gears, task, flywheel_inertia(upstream, wheel, gears))
    return Asked(inertia, driver(upstream, wish, gears, task), mean_speed(upstream, task))


def dump(result: Motion) -> Record:
    """Arrays by the names of the fields; the dense regimes under ``regime.`` and ``idle.``."""
    return to_record(result, plain(result.regime.errors))


def load(record: Record) -> Motion:
    """Build the result from its record."""
    result: Motion = from_record(Motion, record)
    return result


def table(result: Motion) -> Table:
    """All columns, one row a position."""
    chosen = motion_columns(result)
    return Table(["i", *(c.header for c in chosen)], Late([np.array(result.labels), *(c.make for c in chosen)]))
