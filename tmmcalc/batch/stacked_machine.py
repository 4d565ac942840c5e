"""The steady motions of stacked variants with their motors."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.machine.driver import driver_of
from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.machine.stacked import FIGURES, Regimes, figures, is_smooth, machines_of, regimes, spots
from tmmcalc.numerics.alike import Rows
from tmmcalc.numerics.panels import Values

if TYPE_CHECKING:
    from tmmcalc.linkage.stacked.scene import Block
    from tmmcalc.machine.motion import Motion
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.motors.model import Motor
    from tmmcalc.numerics.roots import Indices
    from tmmcalc.pipeline.outcome import RunResult

Machine = tuple[MotorChoice | None, Gears, MotionTask, FlywheelTask | None]


def refusal(machine: Machine, base: RunResult) -> str | None:
    """Why steady motions of such machines cannot be found together; None if they can."""
    motor, gears, task, wheel = machine
    if motor is None or motor.motor is None or task.positional or motor.motor.time_constant:
        return "a motion that no given motor without lag drives"
    if wheel is not None and not wheel.inertia:
        return "the flywheel has to be found"
    speed = base.results["kinematics"].speed
    return None if is_smooth(_characteristic(motor, gears, speed)) else "a characteristic with bends"


def motions_of(
    block: Block, variants: Indices, machine: Machine, base: Motion, wanted: Collection[str]
) -> tuple[Motion, dict[str, Values], NDArray[np.bool_]]:
    """The motions of some variants (v,), at the positions of one behind the other; their figures; which are clear.

    Only the ``wanted`` columns and figures are found, by their names in the table and the summary.
    """
    from tmmcalc.linkage.stacked.reduction import cycles_of

    own = Rows(machine)(variants)
    motor, speed = own[0], block.chain(variants).mechanism.input.speed
    assert motor is not None
    cycles = cycles_of(block, variants)
    # constants of the characteristic stand against arrays (V, K, N)
    driver = Rows(_characteristic(motor, own[1], speed))(np.arange(len(variants))[:, None, None])
    found = regimes(machines_of(cycles, len(variants), _constant(own, speed), driver))
    told = figures(found) if any(name in FIGURES for name in wanted) else {}
    return _at_positions(found, base, wanted), told, cycles.clear & found.clear


def _ratio(motor: Motor, gears: Gears, speed: float) -> float:
    """Speed of the motor over that of the input."""
    return gears.ratio or motor.speed / abs(speed)


def _characteristic(motor: MotorChoice, gears: Gears, speed: float) -> Characteristic:
    """The characteristic at the input shaft."""
    assert motor.motor is not None
    ratio = _ratio(motor.motor, gears, speed)
    return driver_of(motor.motor, motor.characteristic, ratio, gears.efficiency).characteristic


def _constant(machine: Machine, speed: float) -> float:
    """All constant inertia at the input shaft [kg*m^2]."""
    motor, gears, task, wheel = machine
    assert motor is not None
    assert motor.motor is not None
    ratio = _ratio(motor.motor, gears, speed)
    inertia = (motor.motor.inertia or 0.0) * ratio**2 + (gears.inertia or 0.0) + task.inertia
    if wheel is None:
        return inertia
    turned = (ratio if wheel.shaft == "motor" else wheel.ratio) or 1.0
    return inertia + wheel.inertia * turned**2


def _at_positions(found: Regimes, base: Motion, wanted: Collection[str]) -> Motion:
    """The motion at the positions of all machines."""
    m = found.machines
    at = spots(m, np.clip(base.theta, 0.0, base.regime.panels.edges[-1]))
    rows: dict[str, Any] = {"phi": np.tile(base.phi, len(m.low))}
    if "omega" in wanted:
        rows["omega"] = at.at(found.omega).ravel()
    if "eps" in wanted:
        rows["eps"] = at.at(found.acceleration).ravel()
    if "t" in wanted:
        rows["time"] = at.primitive(m, 1 / found.omega).ravel()
    if "M_d" in wanted:
        rows["driving"] = at.at(found.driving).ravel()
    if "M_load" in wanted:
        rows["load"] = at.at(found.load).ravel()
    return replace(base, **rows)
