"""Steady motion with a motor whose moment depends on speed: the regime that the machine settles in.

The regime is the periodic solution of the total equation of motion that is reached from the no-load speed. It is found
by collocation over the whole cycle, not by turning the machine until it settles, so that a heavy flywheel costs nothing
and a steep characteristic needs no small steps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.collocation import TOLERANCE, Orbit
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.onemass import SPEEDS, OneMass, balanced_speed, check_inertia, onto
from tmmcalc.machine.regime import Regime, multipliers, regime_of
from tmmcalc.machine.settling import Guess, Halt, directly, followed, guessed
from tmmcalc.machine.stall import check_mean_load, check_no_load, halted

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

WHERE = "steady motion"
NOTHING = 1e-13  # moment of the load, against what the motor gives at standstill by its slope, that is none
# moment of the whole speed by the motor's slope, over that which accelerates: digits worth a second solution
LOSS = 1e3
INDIFFERENT = 1e-13  # change of the moment over the speed itself, against the moment


def driven(
    cycle: Cycle,
    constant_inertia: float,
    characteristic: Characteristic,
    *,
    time_constant: float = 0.0,
    guess: Regime | None = None,
    sense: float = 1.0,
    tolerance: float = 0.0,
) -> Regime:
    """The regime with a motor whose ``characteristic`` is reduced to the input shaft (the exact form of textbook 3.57).

    ``constant_inertia`` [kg*m^2] is added to that of the cycle. With a ``time_constant`` tau_e [s] the moment of the
    motor lags: tau_e dM/dt = M_static(omega) - M. ``guess``, the regime of a similar machine, saves a little time;
    ``sense`` is -1 where the input turns clockwise: messages tell places by its coordinate. ``tolerance`` is the
    relative error that is asked for (0: near rounding); where not all that is told keeps it so, that is sought.
    Raises `NoSolutionError` where the machine stalls (with the angle, and the inertia that would carry it over the
    peak), runs away, is overloaded on the average, or does not regulate itself; `UsageError` for impossible
    arguments; `AccuracyError` if the regime cannot be told.
    """
    if not (0 <= constant_inertia < np.inf and 0 <= time_constant < np.inf):
        raise UsageError(
            f"a constant inertia of {constant_inertia:g} kg*m^2 with a time constant of {time_constant:g} s",
            where=WHERE,
            remedy="both are finite and not negative",
        )
    check_inertia(cycle, constant_inertia, sense)
    machine = OneMass(cycle, constant_inertia, characteristic, time_constant, sense, tolerance)
    _check_regulation(machine)
    free = _free(machine)
    if free is not None:
        return free
    if balanced_speed(machine) is None:
        check_mean_load(machine)
        check_no_load(machine)
    near = None if guess is None else guessed(machine, _guess(cycle, guess), guess.constant_inertia)
    found = directly(machine, near) or followed(machine)
    if isinstance(found, Halt):
        raise halted(machine, found)
    regime = regime_on(machine, found)
    if 0 < tolerance < regime.errors.largest:
        return driven(cycle, constant_inertia, characteristic, time_constant=time_constant, guess=regime, sense=sense)
    return regime


def _free(machine: OneMass) -> Regime | None:
    """The regime where nothing acts on the shaft and its inertia is constant: the no-load speed; None elsewhere."""
    cycle, motor = machine.cycle, machine.characteristic
    w = motor.synchronous
    if w is None:
        return None
    fall = -motor.slope(w)
    load = np.abs(cycle.moment) + np.abs(cycle.viscous) * w + (np.abs(cycle.quadratic) + np.abs(cycle.slope)) * w * w
    if fall <= 0 or np.max(load) > NOTHING * fall * w:
        return None
    inertia, still = machine.constant + float(np.mean(cycle.inertia)), np.zeros(cycle.panels.x.shape)
    rates = np.array([-fall / (inertia * w)])
    if machine.lag:
        tau = machine.lag
        rates = np.linalg.eigvals([[0.0, 1 / (inertia * w)], [-fall / (tau * w), -1 / (tau * w)]])
    multiplier = tuple(complex(v) for v in sorted(np.exp(rates * cycle.period), key=abs, reverse=True))
    counters = {"newton": 0, "meshes": 1}
    return regime_of(cycle, machine.constant, still + w, still, multiplier, still[:, 0] + NOTHING, counters)


def _guess(cycle: Cycle, regime: Regime) -> Guess:
    """The speed of a regime on panels that suit the cycle."""
    have, need = regime.panels.edges, cycle.panels.edges
    if np.array_equal(have[np.minimum(np.searchsorted(have, need), len(have) - 1)], need):
        return regime.panels, regime.omega
    x = np.clip(cycle.panels.x, regime.panels.edges[0], regime.panels.edges[-1])
    return cycle.panels, regime.panels.at(regime.omega, x.ravel()).reshape(x.shape)


def regime_on(machine: OneMass, orbit: Orbit) -> Regime:
    """The regime that a machine settles in on an orbit; of one so steep that digits are lost it is regained."""
    motor, panels = machine.characteristic, orbit.panels
    omega = machine.speed(panels, orbit.y[0])
    driving, excess, last, noise = orbit.y[1] if machine.lag else motor.moment(omega), None, orbit, 0.0
    counters = {"newton": orbit.iterations, "meshes": orbit.passes}
    if _is_steep(machine, panels, omega, driving):
        from tmmcalc.machine.steepmotor import regained

        again = regained(machine, panels, omega, driving)
        if again is not None:
            last, excess, driving, noise = again.orbit, again.excess, again.driving, again.noise
            panels, omega = last.panels, excess.reference + excess.w
            counters = {"newton": orbit.iterations + last.iterations, "meshes": orbit.passes + last.passes}
    return regime_of(
        onto(machine.cycle, panels),
        machine.constant,
        omega,
        driving,
        multipliers(orbit),
        last.missing[0] + noise,
        counters,
        fall=motor.slope(omega),
        own=float(np.max(last.missing[1])) if machine.lag else 0.0,
        lags=machine.lag > 0,
        ringing=_ringing(machine, motor.slope(omega)),
        excess=excess,
    )


def _ringing(machine: OneMass, slope: Values) -> float:
    """Amplitude at resonance of a motor with its lag as a spring, over that of slow changes; 1 without lag."""
    least = machine.constant + float(np.min(machine.cycle.inertia))
    return max(1.0, float(np.sqrt(np.max(np.abs(slope)) * machine.lag / least)))


def _is_steep(machine: OneMass, panels: Panels, omega: Values, driving: Values) -> bool:
    """Whether so many digits of the acceleration are lost, and digits are asked for."""
    if machine.tolerance > TOLERANCE:
        return False
    cycle = onto(machine.cycle, panels)
    load = cycle.moment + (cycle.viscous + cycle.quadratic * omega) * omega
    left = float(np.max(np.abs(driving + load - cycle.slope * omega * omega / 2)))
    return float(np.max(np.abs(machine.characteristic.slope(omega)) * omega)) > LOSS * left


def _check_regulation(machine: OneMass) -> None:
    """Raise `NoSolutionError` if no moment depends on the speed: any speed would do, or none."""
    cycle, speeds = machine.cycle, machine.reference * SPEEDS
    if np.any(cycle.viscous) or np.any(cycle.quadratic):
        return
    moment = machine.characteristic.moment(speeds)
    change = np.max(np.abs(machine.characteristic.slope(speeds) * speeds))
    if change > INDIFFERENT * np.max(np.abs(moment)):
        return
    surplus = float(moment[0] * cycle.period + cycle.panels.total(cycle.moment))
    raise NoSolutionError(
        "neither the driving moment nor a resistance depends on the speed, so the machine does not regulate itself "
        f"(multiplier 1): every cycle adds {surplus:.4g} J at any speed",
        where=WHERE,
        value=1.0,
        limit=1.0,
        remedy="take the motor's characteristic, or forces of position alone with a constant balancing moment",
    )
