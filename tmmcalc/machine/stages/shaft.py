"""What several machine stages make of the spec and the earlier stages: the driver and the constant inertia."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of

if TYPE_CHECKING:
    from tmmcalc.machine.flywheel.results import Flywheel
    from tmmcalc.machine.model import FlywheelTask, MotionTask, MotorChoice
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.reduction.results import Reduction

EQUAL = 1e-9  # relative difference of steps that count as equal


def driver(upstream: Mapping[str, Any], wish: MotorChoice | None, task: MotionTask) -> Driver | None:
    """The motor on the input shaft; None if the motion is positional."""
    power: Power = upstream["power"]
    if task.positional or wish is None or power.duty is None:
        return None
    duty = power.duty
    return driver_of(duty.motor, wish.characteristic, duty.ratio, power.line.efficiency, duty.motor.time_constant)


def constant_inertia(upstream: Mapping[str, Any], task: MotionTask, flywheel: float = 0.0) -> ConstantInertia:
    """Rotor, gears, further inertia of the spec, and the flywheel, all at the input shaft."""
    power: Power = upstream["power"]
    rotor = power.duty.rotor if power.duty is not None else 0.0
    line = power.line
    return ConstantInertia(rotor, line.inertia, task.inertia, flywheel, line.inertia_of, line.open)


def sense(reduction: Reduction) -> float:
    """1, or -1 where the input turns clockwise: places are told by its coordinate."""
    return math.copysign(1.0, reduction.phi[-1] - reduction.phi[0])


def equal_steps(reduction: Reduction) -> int | None:
    """Number of equal steps of the positions over the whole cycle; None if they differ, or are too few."""
    steps, n = np.abs(np.diff(reduction.phi)), len(reduction.phi) - 1
    step = reduction.cycle.period / max(n, 1)
    return n if n > 2 and float(np.max(np.abs(steps - step))) < EQUAL * step else None


def motor_ratio(power: Power) -> float | None:
    """Speed of the motor's shaft over that of the input shaft; None if there is none."""
    return power.duty.ratio if power.duty is not None else power.line.ratio


def shaft_ratio(task: FlywheelTask, power: Power) -> float:
    """Speed of the flywheel's shaft over that of the input shaft."""
    return (motor_ratio(power) if task.shaft == "motor" else task.ratio) or 1.0


def flywheel_inertia(upstream: Mapping[str, Any], wheel: FlywheelTask | None) -> float:
    """Inertia at the input shaft of the flywheel that is there, or else of the one that was found [kg*m^2]."""
    if wheel is not None and wheel.inertia:
        return wheel.inertia * shaft_ratio(wheel, upstream["power"]) ** 2
    found: Flywheel | None = upstream.get("flywheel")
    return found.addition if found is not None else 0.0


def mean_speed(upstream: Mapping[str, Any], task: MotionTask) -> float:
    """Mean speed of the positional motion [rad/s]."""
    reduction: Reduction = upstream["reduction"]
    return task.speed or reduction.cycle.speed
