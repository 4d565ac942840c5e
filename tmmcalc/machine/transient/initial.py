"""What a run begins with: the reduced system, its sizes, the tolerances, and the initial state."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.transient.equations import WORKS, Curve, System
from tmmcalc.machine.transient.model import Drive, reduced
from tmmcalc.machine.transient.pointwise import reader, stretches
from tmmcalc.machine.transient.profile import Profile
from tmmcalc.machine.transient.scenario import Scenario

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

ROUNDED = 32 * math.ulp(1.0)  # of a speed in the equations of a step, with room for Newton to tell that it has settled


class Sizes(NamedTuple):
    """The sizes on the crank's shaft that tolerances are relative to."""

    speed: float  # [rad/s]
    moment: float  # [N*m]
    energy: float  # [J]


def assembled(drive: Drive, scenario: Scenario, profile: Profile, rigid: frozenset[int]) -> System:
    """The system of equations with the masses of ``rigid`` shafts joined.

    Raises `UsageError` if the crank has no inertia or the brake no mass.
    """
    chain = reduced(drive, rigid)
    if chain.inertia[-1] + profile.least_inertia <= 0:
        raise UsageError(
            "the crank has no inertia in some position, so that its acceleration is not defined",
            where="transient motion",
            value=chain.inertia[-1] + profile.least_inertia,
            limit=0.0,
            remedy="give the constant inertia of the crank's shaft [kg*m^2]: rotor, gears, flywheel",
        )
    moment, slope = _motor(drive.characteristic, chain.motor_ratio)
    mass = brake_mass(drive, scenario)
    brake, u = scenario.brake, chain.ratio[mass]
    grip, drag = (brake.moment * u, brake.viscous * u * u) if brake else (0.0, 0.0)
    return System(chain, moment, slope, drive.time_constant, chain.group[mass], grip, drag)


def _motor(characteristic: Characteristic | None, u: float) -> tuple[Curve | None, Curve | None]:
    """Moment and slope of the motor on the crank's shaft, in plain floats."""
    if characteristic is None:
        return None, None
    moment, slope = characteristic.moment, characteristic.slope

    def curve(w: float) -> float:
        try:
            return u * float(moment(u * w))
        except ArithmeticError:  # a trial step went far off; it will be refused
            return math.nan

    return curve, lambda w: u * u * float(slope(u * w))


def brake_mass(drive: Drive, scenario: Scenario) -> int:
    """Index of the mass with the brake; the crank's if there is none."""
    count = len(drive.masses)
    mass = scenario.brake.mass if scenario.brake else -1
    if not -count <= mass < count:
        raise UsageError(
            f"the brake is on mass {mass} of a drive of {count}",
            where=f"transient motion, scenario {scenario.name}",
            value=mass,
            limit=count - 1,
            remedy=f"a number from 0, the motor's mass, to {count - 1}, the crank's",
        )
    return mass % count


def _rated(drive: Drive, u: float) -> list[float]:
    """Speed of the crank at the rated speed of the motor, if that is known."""
    motor = drive.characteristic
    return [] if motor is None or motor.nominal is None else [motor.nominal / u]


def working(drive: Drive, scenario: Scenario, u: float) -> set[float]:
    """Speeds of the crank at which the drive works [rad/s]: at first, on the average, rated, without load."""
    known = {scenario.speed, *_rated(drive, u)}
    if drive.cycle is not None:
        known.add(drive.cycle.speed)
    if drive.characteristic is not None and drive.characteristic.synchronous is not None:
        known.add(drive.characteristic.synchronous / u)
    return known


def known_speeds(drive: Drive, scenario: Scenario, u: float) -> set[float]:
    """All speeds of the crank that are known beforehand [rad/s]: `working` ones, targets, that which ends the run."""
    ends = () if scenario.end_speed is None else (scenario.end_speed,)
    return {*working(drive, scenario, u), *scenario.targets, *ends}


def sizes(drive: Drive, system: System, scenario: Scenario, profile: Profile) -> Sizes:
    """Largest speed, moment and energy that are known beforehand."""
    u = system.chain.motor_ratio
    speed = max(map(abs, known_speeds(drive, scenario, u)))
    factor = max(1.0, *(abs(step.factor) for step in scenario.load))
    driving = [system.moment(w) for w in (scenario.speed, *_rated(drive, u))] if system.moment else []
    inertia = sum(system.chain.inertia) + max(profile.least_inertia, 0.0)
    moment = max(factor * profile.largest_moment, system.grip, system.drag * speed, *map(abs, driving))
    if moment == 0:
        moment = inertia * speed * speed or 1.0
    speed = speed or moment * scenario.duration / inertia
    return Sizes(speed, moment, inertia * speed * speed / 2)


def allowed(system: System, size: Sizes, tolerance: float) -> list[float]:
    """Error allowed in one step, of every component of the state; of a lagging moment no less than can be told.

    The speed is rounded, and the motor's slope makes of that a moment which no step resolves.
    """
    twists = [tolerance * size.moment / c if c else tolerance for c in system.chain.stiffness]
    rates = [tolerance * size.speed] * system.layout.groups
    fall = abs(system.slope(size.speed)) if system.slope is not None else 0.0
    lag = [max(tolerance * size.moment, ROUNDED * fall * size.speed)] * system.layout.lag
    return [tolerance, *twists, *rates, *lag, *[tolerance * size.energy] * WORKS]


def initial(system: System, scenario: Scenario, profile: Profile) -> list[float]:
    """The state at t = 0; if ``settled``, with the static moment of the motor and the twists of rigid motion."""
    layout, chain, w = system.layout, system.chain, scenario.speed
    n = layout.groups
    y = [scenario.angle, *[0.0] * (n - 1), *[w] * n, *[0.0] * (layout.size - 2 * n)]
    if not scenario.settled:
        return y
    index, base = profile.place(scenario.angle, w >= 0)
    factor = scenario.load[0].factor
    inertia, slope, load = reader(stretches(profile, factor)[index], base)(scenario.angle, w)
    drive = system.moment(w) if system.moment and scenario.motor_on(0.0) else 0.0
    if layout.lag:
        drive = drive if scenario.moment is None or not scenario.motor_on(0.0) else scenario.moment
        y[2 * n] = drive
    at_rest = w == 0 and drive + load <= 0 and scenario.standstill == "stop"
    rate = 0.0 if at_rest else (drive + load - slope * w * w / 2) / (sum(chain.inertia) + inertia)
    carried = drive - np.cumsum(chain.inertia[:-1]) * rate
    y[1:n] = [float(m / c) if c else 0.0 for m, c in zip(carried, chain.stiffness, strict=True)]
    return y
