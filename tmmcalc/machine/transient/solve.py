"""Motions in time of a machine as its project asks for them: the drive put together, each scenario run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.model import DriveShaft, TransientTask
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.positional import positional
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.selfregulation import self_regulated
from tmmcalc.machine.steady import driven
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Back, Drive, Mass, ratios
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions
from tmmcalc.machine.transient.verdicts import rated_moment
from tmmcalc.machine.verdicts import Verdict

if TYPE_CHECKING:
    from tmmcalc.machine.motors.braking import Braking
    from tmmcalc.machine.motors.model import Motor


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
    back: Back | None = None  # both cycles with the friction of the crank turning back, if pairs rub
    undriven: bool = False  # the steady motion is that of the loads alone
    notes: tuple[str, ...] = ()  # on what the drive takes of the project
    data: Motor | None = None  # of the motor, by which it may brake
    efficiency: float = 1.0  # of the gears


def solve_transients(
    machine: Machine, tasks: Sequence[TransientTask], speed: float, error: float = 0.0
) -> TimedMotions:
    """Run every scenario; ``speed`` [rad/s] is the mean one of a steady motion without a motor.

    An ``error`` asked of the speeds takes the place of the tolerances of all methods with step control.
    Raises `NoSolutionError` for a scenario that starts in a steady motion that the machine has not.
    """
    names = drive_of(machine)[1]
    motions = []
    for task, (drive, scenario) in zip(tasks, beginning(machine, tasks, speed), strict=True):
        found = simulate(drive, scenario, replace(task.method, error=error) if error else task.method)
        elastic = any(shaft.stiffness < math.inf for shaft in drive.shafts)
        told = (*_excited(machine, task, found), *(Verdict("note", note) for note in machine.notes))
        motions.append(_motion(found, names, _rigid_moments(drive, scenario) if elastic else (), told))
    return TimedMotions(tuple(motions))


def beginning(machine: Machine, tasks: Sequence[TransientTask], speed: float) -> list[tuple[Drive, Scenario]]:
    """The drive and, for every task, the scenario with the speed that it begins with; raises as `solve_transients`."""
    drive = drive_of(machine)[0]
    steady = _steady(machine, speed) if any(task.steady for task in tasks) else None
    begun = [(task.braking, _started(task, steady)) for task in tasks]
    return [
        (drive if how is None else drive_of(_braked(machine, how, scenario))[0], scenario) for how, scenario in begun
    ]


def _braked(machine: Machine, how: Braking, scenario: Scenario) -> Machine:
    """The machine with its motor connected as a brake."""
    from tmmcalc.machine.motors.braking import braking
    from tmmcalc.machine.motors.gearing import reduced
    from tmmcalc.machine.transient.excitation import check_excitation

    if machine.data is None:
        return machine
    check_excitation(machine.data, how, scenario, machine.ratio)
    line = braking(machine.data, how)
    own, at_crank = (reduced(line, ratio, machine.efficiency) for ratio in (1.0, machine.ratio))
    return replace(machine, motor=own, reduced=at_crank)


def _excited(machine: Machine, task: TransientTask, found: Transient) -> tuple[Verdict, ...]:
    """What is said of the field of a motor that brakes."""
    if task.braking is None or machine.data is None:
        return ()
    from tmmcalc.machine.transient.excitation import excitation

    return excitation(machine.data, task.braking, found, 1.0 if machine.shafts else machine.ratio)


def drive_of(machine: Machine) -> tuple[Drive, tuple[str, ...]]:
    """The drive and the names of its masses: one mass, or a chain from the rotor to the crank."""
    inertia = machine.inertia
    if not machine.shafts:
        one = Mass(inertia.total, "crank")
        drive = Drive((one,), (), machine.reduced, machine.cycle, machine.idle, machine.time_constant, machine.back)
        return drive, ("crank",)
    at_motor = inertia.rotor + (inertia.flywheel if machine.wheel_at_motor else 0.0)
    at_crank = inertia.gears + inertia.further + (0.0 if machine.wheel_at_motor else inertia.flywheel)
    masses = [Mass(at_motor / machine.ratio**2, "rotor")]
    masses += [Mass(shaft.inertia, f"behind {shaft.name}") for shaft in machine.shafts[:-1]]
    masses.append(Mass(machine.shafts[-1].inertia + at_crank, "crank"))
    shafts = tuple(shaft.shaft for shaft in machine.shafts)
    motor = (machine.motor, machine.cycle, machine.idle, machine.time_constant)
    drive = Drive(tuple(masses), shafts, *motor, machine.back)
    return drive, tuple(mass.name for mass in masses)


def _steady(machine: Machine, speed: float) -> Regime:
    """The steady motion, the drive taken as rigid."""
    if machine.undriven:
        return self_regulated(machine.cycle, machine.inertia.total)
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


def _rigid_moments(drive: Drive, scenario: Scenario) -> tuple[float, ...]:
    """Largest moment of every shaft in the same motion with all shafts rigid [N*m], each on its own shaft."""
    rigid = replace(drive, shafts=tuple(replace(shaft, stiffness=math.inf) for shaft in drive.shafts))
    moments = simulate(rigid, scenario, Method(compared=False)).largest_moment[0, :-1]
    return tuple(np.abs(moments).tolist())


def _motion(
    found: Transient, names: tuple[str, ...], rigid_moment: tuple[float, ...], told: tuple[Verdict, ...]
) -> TimedMotion:
    motor = found.drive.characteristic
    own: dict[str, Any] = {
        "name": found.scenario.name,
        "masses": names,
        "ratios": ratios(found.drive),
        "rigid_moment": rigid_moment,
        "rated_moment": rated_moment(motor),
        "verdicts": tuple(sorted((*found.verdicts, *told), key=lambda verdict: verdict.severity == "note")),
    }
    rest = (field.name for field in fields(TimedMotion) if field.name not in own)
    return TimedMotion(**own, **{field: getattr(found, field) for field in rest})
