"""Motions in time of a machine as its project asks for them: the drive put together, each scenario run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.model import DriveShaft, TransientTask
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.positional import positional
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.steady import driven
from tmmcalc.machine.transient.model import Drive, Mass, ratios
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions
from tmmcalc.records import record


@record
class Machine:
    """What of the machine its motions in time need."""

    cycle: Cycle
    idle: Cycle | None
    inertia: ConstantInertia  # reduced to the input shaft
    motor: Characteristic | None  # on the motor shaft
    reduced: Characteristic | None  # the same on the input shaft
    time_constant: float  # [s]
    ratio: float  # speed of the motor over that of the input shaft
    shafts: tuple[DriveShaft, ...] = ()
    wheel_at_motor: bool = False  # the flywheel turns with the motor


def solve_transients(machine: Machine, tasks: Sequence[TransientTask], speed: float) -> TimedMotions:
    """Run every scenario; ``speed`` [rad/s] is the mean one of a steady motion without a motor.

    Raises `NoSolutionError` for a scenario that starts in a steady motion that the machine has not.
    """
    drive, names = drive_of(machine)
    steady = _steady(machine, speed) if any(task.steady for task in tasks) else None
    motions = []
    for task in tasks:
        found = simulate(drive, _started(task, steady), task.method)
        motions.append(_motion(found, task.scenario.name, names))
    return TimedMotions(tuple(motions))


def drive_of(machine: Machine) -> tuple[Drive, tuple[str, ...]]:
    """The drive and the names of its masses: one mass, or a chain from the rotor to the crank."""
    inertia = machine.inertia
    if not machine.shafts:
        one = Mass(inertia.total, "crank")
        return Drive((one,), (), machine.reduced, machine.cycle, machine.idle, machine.time_constant), ("crank",)
    at_motor = inertia.rotor + (inertia.flywheel if machine.wheel_at_motor else 0.0)
    at_crank = inertia.gears + inertia.further + (0.0 if machine.wheel_at_motor else inertia.flywheel)
    masses = [Mass(at_motor / machine.ratio**2, "rotor")]
    masses += [Mass(shaft.inertia, f"behind {shaft.name}") for shaft in machine.shafts[:-1]]
    masses.append(Mass(machine.shafts[-1].inertia + at_crank, "crank"))
    shafts = tuple(shaft.shaft for shaft in machine.shafts)
    drive = Drive(tuple(masses), shafts, machine.motor, machine.cycle, machine.idle, machine.time_constant)
    return drive, tuple(mass.name for mass in masses)


def _steady(machine: Machine, speed: float) -> Regime:
    """The steady motion, the drive taken as rigid."""
    if machine.reduced is None:
        return positional(machine.cycle, machine.inertia.total, speed)
    return driven(machine.cycle, machine.inertia.total, machine.reduced, time_constant=machine.time_constant)


def _started(task: TransientTask, steady: Regime | None) -> Scenario:
    """The scenario with the speed and the motor's moment of the steady motion at its beginning."""
    if not task.steady or steady is None:
        return task.scenario
    start = np.zeros(1)
    moment = float(steady.panels.at(steady.driving, start)[0])
    return replace(task.scenario, speed=float(steady.omega_at(start)[0]), moment=moment)


def _motion(found: Transient, name: str, names: tuple[str, ...]) -> TimedMotion:
    own: dict[str, Any] = {"name": name, "masses": names, "ratios": ratios(found.drive)}
    rest = (field.name for field in fields(TimedMotion) if field.name not in own)
    return TimedMotion(**own, **{field: getattr(found, field) for field in rest})
