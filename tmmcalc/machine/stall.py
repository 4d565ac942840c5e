"""When the motor cannot carry the machine through its cycle: the least inertia that can, and what there is to say."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.collocation import Orbit
from tmmcalc.machine.cycle import Cycle, place
from tmmcalc.machine.driver import UNDRIVEN
from tmmcalc.machine.onemass import SPEEDS, OneMass
from tmmcalc.machine.settling import RUNAWAY, Guess, Halt, directly, followed, next_to

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

WHERE = "steady motion"
FIRST = 10.0  # first trial: the inertia with which the surplus work changes the speed by a tenth
GROWTH = 10.0
LARGEST = 1e9  # times the first trial: where the search upwards ends
LEAST = 1e-9  # times an inertia that carries the load: with so little the links alone do
STEP = 0.8  # from one inertia to the next smaller one: near enough for the regime to be continued
UNLOADED = 1e-12  # mean moment of the loads against the largest of the motor that is rounding
MESSAGE = 1e-3  # tolerance of the inertia in a message

Machine = Callable[[float], OneMass]  # of its constant inertia


def stall_inertia(
    cycle: Cycle,
    characteristic: Characteristic,
    *,
    time_constant: float = 0.0,
    tolerance: float = 1e-6,
    stalls: float = 0.0,
) -> float:
    """Least constant inertia [kg*m^2] that carries the machine through its peak load, to a relative ``tolerance``.

    ``stalls`` is one that is known not to; zero if the links alone carry it. Raises `NoSolutionError` if the mean load
    is too much for the motor, or the machine does not settle with any inertia.
    """
    machine = _family(cycle, characteristic, time_constant)
    check_mean_load(machine(1.0))
    carrying = _carrying(machine, stalls)
    none = LEAST * carrying[0]
    if stalls < none and _regime(machine(none)) is not None:
        return 0.0
    return _threshold(machine, max(stalls, none), carrying, tolerance)


def _family(cycle: Cycle, characteristic: Characteristic, lag: float) -> Machine:
    return lambda inertia: OneMass(cycle, inertia, characteristic, lag)


def _threshold(machine: Machine, stalls: float, carrying: tuple[float, Orbit], tolerance: float) -> float:
    """The least inertia that carries the load, between one that ``stalls`` and one that is known to carry it."""
    high, orbit = carrying
    low = stalls
    while True:
        while high > low * (1 + tolerance):
            middle = max((low * high) ** 0.5, STEP * high)
            found = next_to(machine(middle), _guess(machine(high), orbit))
            if found is None:
                low = middle
            else:
                high, orbit = middle, found
        # so far a periodic solution that was not found counted as a stall; the motion itself decides
        lower = _regime(machine(low)) if low > stalls else None
        if lower is None:
            return high
        high, orbit, low = low, lower, stalls


def _carrying(machine: Machine, stalls: float) -> tuple[float, Orbit]:
    """An inertia that carries the load, larger than one that ``stalls``, and the regime with it."""
    cycle, reference = machine(1.0).cycle, machine(1.0).reference
    work = cycle.panels.primitive(cycle.moment - cycle.panels.total(cycle.moment) / cycle.period)[0]
    inertia = first = max(FIRST * float(np.ptp(work)) / reference**2, GROWTH * stalls) or 1.0
    while inertia <= LARGEST * first:
        found = directly(machine(inertia))
        if found is not None:
            return inertia, found
        inertia *= GROWTH
    raise NoSolutionError(
        f"the machine settles in no regime, not even with a constant inertia of {inertia:.4g} kg*m^2",
        where=WHERE,
        value=inertia,
        remedy="a motor whose moment falls with the speed, or less load",
    )


def _regime(machine: OneMass) -> Orbit | None:
    """The regime that a machine settles in, None if it stops or cannot be followed."""
    try:
        found = directly(machine) or followed(machine)
    except AccuracyError:
        return None
    return found if isinstance(found, Orbit) else None


def _guess(machine: OneMass, orbit: Orbit) -> Guess:
    return orbit.panels, machine.speed(orbit.panels, orbit.y[0])


def check_mean_load(machine: OneMass) -> None:
    """Raise `NoSolutionError` if no speed lets the motor balance the mean load: no inertia helps then."""
    cycle, motor = machine.cycle, machine.characteristic
    if np.any(cycle.viscous > 0) or np.any(cycle.quadratic > 0):
        return
    mean = float(cycle.panels.total(cycle.moment)) / cycle.period
    largest = float(np.max(motor.moment(machine.reference * SPEEDS)))
    if motor.critical is not None:
        largest = max(largest, float(motor.moment(motor.critical)))
    if largest + mean >= 0:
        return
    raise NoSolutionError(
        f"the mean resisting moment {-mean:.6g} N*m exceeds the largest moment of the motor, {largest:.6g} N*m: "
        "the machine stops whatever its inertia",
        where=WHERE,
        value=-mean,
        limit=largest,
        remedy="a stronger motor, a larger ratio of the gear train, or less load",
    )


def check_no_load(machine: OneMass) -> None:
    """Raise `NoSolutionError` if nothing resists a motor that drives at every speed: no inertia and no time help then.

    A regime needs loads that take, on the average, what the motor gives.
    """
    cycle, motor, reference = machine.cycle, machine.characteristic, machine.reference
    if motor.synchronous is not None or np.any(cycle.viscous < 0) or np.any(cycle.quadratic < 0):
        return
    mean = float(cycle.panels.total(cycle.moment)) / cycle.period
    given = motor.moment(reference * np.append(SPEEDS, RUNAWAY))
    if np.min(given) <= 0 or mean < -UNLOADED * np.max(given):
        return
    raise NoSolutionError(
        f"the machine runs away: the motor ({motor.name}) has no no-load speed, at {RUNAWAY * reference:.6g} rad/s of "
        f"the crank it still drives with {given[-1]:.6g} N*m, and the loads do not resist it: their mean moment is "
        f"{mean if abs(mean) > UNLOADED * np.max(given) else 0.0:.6g} N*m",
        where=WHERE,
        value=mean,
        limit=0.0,
        remedy="a load that resists (a negative moment), or a motor that has a no-load speed, such as a shunt one",
    )


def halted(machine: OneMass, halt: Halt) -> NoSolutionError:
    """The error that tells where a machine stops or runs away, and what would help."""
    start = "the speed that balances its mean load" if machine.characteristic.name == UNDRIVEN else "the no-load speed"
    angle = f"{place(halt.theta, machine.sense)} of cycle {halt.turn} from {start}"
    if not halt.stall:
        return NoSolutionError(
            f"the machine runs away: the loads drive it faster than anything can brake, {angle}",
            where=WHERE,
            value=halt.theta,
            remedy="a motor that brakes more, or a characteristic that holds above the no-load speed",
        )
    inertia, advice = _needed(machine)
    return NoSolutionError(
        f"the machine stalls at {angle}: the kinetic energy of {machine.constant:.6g} kg*m^2 does not carry it over "
        "the peak of the load",
        where=WHERE,
        value=machine.constant,
        limit=inertia,
        remedy=advice,
    )


def _needed(machine: OneMass) -> tuple[float | None, str]:
    """Inertia that would carry a stalled machine, and the advice; no inertia if none is known to."""
    otherwise = "a motor with a larger break-down moment, or less load"
    if machine.characteristic.name == UNDRIVEN:
        otherwise = "less load"
    try:
        family = _family(machine.cycle, machine.characteristic, machine.lag)
        inertia = _threshold(family, machine.constant, _carrying(family, machine.constant), MESSAGE)
    except (NoSolutionError, AccuracyError):
        return None, otherwise
    return inertia, f"a constant inertia of at least {inertia:.4g} kg*m^2 (a flywheel), or {otherwise}"
