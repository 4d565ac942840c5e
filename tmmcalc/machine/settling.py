"""The way to the steady regime: from the no-load speed turn by turn, or straight by a periodic solution.

Without lag all motions of the one-mass machine keep their order: a faster one stays faster at every angle. So the
motion that starts at the no-load speed sinks (or rises) to the nearest regime and passes none. A periodic solution is
that regime if all motions between it and the start draw together, which is checked on the slopes of the moments; if
that does not tell, the machine is followed turn by turn until it does, or stands still.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.collocation import Orbit, System, initial, solve
from tmmcalc.core.numerics.panels import NARROWEST, Panels, Values
from tmmcalc.machine.cycle import place
from tmmcalc.machine.onemass import SPEEDS, OneMass, balanced_speed, onto
from tmmcalc.machine.regime import multipliers

TURNS = 300  # cycles followed before the search is given up
SELDOM = 1.25  # times the cycles followed when the regime was last tried: before that it is not tried again
LEG = 1e-8  # tolerance of the motion that is followed
MESHES = 8  # on which a stretch of it is sought, before it is cut
SPENT = 0.75  # of the angle over which the energy would be spent: a panel up to there still resolves the motion
STANDSTILL = 0.005  # of the no-load speed
SLOW = 0.2  # of the no-load speed: a motion that cannot be followed below it has come to a stand
RUNAWAY = 20.0  # times the no-load speed
BETWEEN = np.linspace(0.0, 1.0, 9)[:, None, None]  # motions looked at between two
RINGING = 20.0  # time constants after which swings of a lagging motor have died down
SWINGS = 200.0  # of them that can be followed within seconds
SWING = 0.5  # of the mean speed: more than that a guess does not leave it
NEAR = 0.05  # largest relative distance of a lagging motion from the regime it is to settle in


class Halt(NamedTuple):
    """Why there is no regime: the machine stops, or runs away, in some cycle at some angle."""

    stall: bool
    theta: float  # in the cycle [rad]
    turn: int  # 1 is the first cycle from the no-load speed


Guess = tuple[Panels, Values]  # panels that refine those of the cycle, and a speed (K, N) on them


def guessed(machine: OneMass, motion: Guess, constant: float) -> Guess:
    """A guess from the motion with another ``constant`` inertia: with more of it the speed swings less."""
    panels, omega = motion
    links, mean = float(np.mean(machine.cycle.inertia)), float(np.mean(omega))
    largest = float(np.max(np.abs(omega - mean)))
    factor = (constant + links) / (machine.constant + links)
    return panels, mean + (omega - mean) * (min(factor, SWING * mean / largest) if largest > 0 else factor)


def directly(machine: OneMass, guess: Guess | None = None) -> Orbit | None:
    """The regime reached from the no-load speed, if it is found as a periodic solution and known to be that.

    Without lag first: motions without it keep their order, so the one found is known to be the regime or not.
    """
    without_lag, guesses = replace(machine, lag=0.0), [] if guess is None else [guess]
    even = balanced_speed(machine)
    if even is not None:
        guesses.append((machine.cycle.panels, np.full(machine.cycle.inertia.shape, even)))
    for each in guesses:
        orbit = next_to(without_lag, each)
        if orbit is None or not _draws(without_lag, orbit, None):
            continue
        if not machine.lag:
            return orbit
        speed = without_lag.speed(orbit.panels, orbit.y[0])
        try:
            return solve(machine.equations(), orbit.panels, machine.state(orbit.panels, speed), **machine.resolution)
        except AccuracyError:
            continue
    return None


def next_to(machine: OneMass, guess: Guess) -> Orbit | None:
    """A stable periodic solution near a guess, of whatever origin."""
    try:
        orbit = solve(machine.equations(), guess[0], machine.state(*guess), **machine.resolution)
    except AccuracyError:
        return None
    return orbit if abs(multipliers(orbit)[0]) < 1 else None


def _draws(machine: OneMass, orbit: Orbit, other: Values | None) -> bool:
    """Whether all motions between a regime and another speed draw together over a cycle.

    The ``other`` speed (K, N) is on the panels of the orbit, by default the no-load speed.
    """
    cycle = onto(machine.cycle, orbit.panels)
    omega = machine.speed(orbit.panels, orbit.y[0])
    if other is None:
        other = np.maximum(machine.reference, np.max(omega))
    between = omega + BETWEEN * (other - omega)
    rate = machine.gain(cycle, between) / between
    return float(orbit.panels.total(np.max(rate, axis=0) / (cycle.inertia + machine.constant))) < 0


def followed(machine: OneMass) -> Orbit | Halt:
    """The regime that the motion from the no-load speed at theta = 0 settles in, or where it ends.

    Raises `AccuracyError` if neither shows within `TURNS` cycles, or a lagging motor swings too fast to be followed.
    """
    _check_swings(machine)
    edge = machine.cycle.panels.edges[:1]
    inertia = float(_inertia_at(machine, edge)[0])
    y = np.array([inertia * machine.reference**2 / 2, float(machine.characteristic.moment(machine.reference))])
    y, tried = y[: machine.states], 0
    last: _Leg | None = None
    for turn in range(1, TURNS + 1):
        leg = (_again(machine, last, y) if last is not None else None) or _turn(machine, y, turn)
        if isinstance(leg, Halt):
            return leg
        # a machine may creep for hundreds of cycles through where a regime has just been lost: seldom tried is enough
        if turn > SELDOM * tried:
            tried, orbit = turn, _joined(machine, leg)
            if orbit is not None:
                return orbit
        last, y = leg, leg.edges[:, -1]
    raise AccuracyError(
        f"the speed still changes after {TURNS} cycles from the no-load speed",
        where="steady motion",
        value=float(TURNS),
        remedy="more resistance that grows with speed, a steeper motor characteristic, or less inertia",
    )


def _check_swings(machine: OneMass) -> None:
    """Raise `AccuracyError` where a steep and lagging motor swings too often to be followed.

    Near the no-load speed motor and inertia are a spring of the stiffness b/tau_e with a mass, b the fall of the
    moment with the speed; every jump of the load makes it swing, and the swings die down with exp(-t/(2 tau_e)).
    """
    fall = -float(machine.characteristic.slope(machine.reference))
    if not machine.lag or fall <= 0:
        return
    inertia = float(np.min(machine.cycle.inertia)) + machine.constant
    time = min(RINGING * machine.lag, machine.cycle.period / machine.reference)
    swings = (fall / (machine.lag * inertia)) ** 0.5 * time / (2 * np.pi)
    if swings <= SWINGS:
        return
    raise AccuracyError(
        f"the steep characteristic of the motor and its lag of {machine.lag:g} s make the shaft swing {swings:.3g} "
        "times after every jump of the load: too fast to be followed to the steady motion",
        where="steady motion",
        value=swings,
        limit=SWINGS,
        remedy="time_constant = 0 (a speed without these swings), or a rated speed with more slip",
    )


class _Leg(NamedTuple):
    """One cycle of a motion."""

    panels: Panels
    y: Values  # (m, K, N)
    edges: Values  # (m, K + 1)


def _joined(machine: OneMass, leg: _Leg) -> Orbit | None:
    """The regime next to a motion, if the motion is bound to settle in it."""
    try:
        orbit = solve(machine.equations(), leg.panels, leg.y, **machine.resolution)
    except AccuracyError:
        return None
    energy = leg.panels.at(leg.y[0][None], orbit.panels.x.ravel()).reshape(orbit.y[0].shape)
    omega = machine.speed(orbit.panels, energy)
    if not machine.lag:
        return orbit if _draws(machine, orbit, omega) else None
    apart = np.max(np.abs(omega / machine.speed(orbit.panels, orbit.y[0]) - 1))
    return orbit if apart < NEAR and abs(multipliers(orbit)[0]) < 1 else None


def _again(machine: OneMass, last: _Leg, y: Values) -> _Leg | None:
    """The motion over one more cycle from ``y`` (m,), from the ``last`` one; None if it differs too much from that."""
    try:
        found = solve(
            machine.equations(), last.panels, last.y, ends=initial(y), floor=machine.floor, tolerance=LEG, passes=1
        )
    except AccuracyError:
        return None
    pace = np.sqrt(2 * found.edges[0] / _inertia_at(machine, found.panels.edges)) / machine.reference
    goes_on = bool(np.all((pace > STANDSTILL) & (pace < RUNAWAY)))
    return _Leg(found.panels, found.y, found.edges) if goes_on else None


def _turn(machine: OneMass, y: Values, turn: int) -> _Leg | Halt:
    """The motion over one cycle from the state ``y`` (m,) at theta = 0.

    As many panels at once as Newton's method bears: where it fails, half of them, and of one panel the beginning. What
    is left of a stretch on which it failed, and of which the first half went, is not tried as a whole.
    """
    system, edges = machine.equations(), machine.cycle.panels.edges
    least = 2 * NARROWEST * machine.cycle.period
    todo, failed = [edges], np.inf
    parts: list[Orbit] = []
    while todo:
        bounds = todo.pop()
        lasts = _lasts(machine, bounds[0], y)
        hopeless = bounds[-1] == failed if len(bounds) > 2 else bounds[1] - bounds[0] >= max(lasts, least)
        part = None if hopeless else _part(machine, system, bounds, y)
        if part is None:
            failed = bounds[-1]
            if len(bounds) == 2:
                if bounds[1] - bounds[0] < least:
                    return _stopped(machine, float(bounds[0]), y, turn)
                cut = min(float(np.mean(bounds)), max(float(bounds[0]) + SPENT * lasts, float(bounds[0]) + least / 2))
                bounds = np.insert(bounds, 1, cut)
            middle = len(bounds) // 2
            todo += [bounds[middle:], bounds[: middle + 1]]
            continue
        parts.append(part)
        y, on = part.edges[:, -1], part.panels.edges
        pace = np.sqrt(2 * part.edges[0] / _inertia_at(machine, on)) / machine.reference
        beyond = np.flatnonzero(~((pace > STANDSTILL) & (pace < RUNAWAY)))
        if beyond.size:
            return Halt(bool(pace[beyond[0]] < 1), float(on[beyond[0]]), turn)
    joined = Panels(np.append(np.concatenate([p.panels.edges[:-1] for p in parts]), edges[-1]), parts[0].panels.order)
    ends = np.column_stack([*(p.edges[:, :-1] for p in parts), y])
    return _Leg(joined, np.concatenate([p.y for p in parts], axis=1), ends)


def _part(machine: OneMass, system: System, bounds: Values, y: Values) -> Orbit | None:
    """The motion from ``y`` (m,) over panels with the edges ``bounds``, or finer ones; None if it is not resolved."""
    panels = Panels(bounds, machine.cycle.panels.order)
    omega = np.full((panels.count, panels.order), _speed_at(machine, bounds[0], y))
    guess = machine.state(panels, omega, y[-1] if machine.lag else None)
    try:
        return solve(system, panels, guess, ends=initial(y), floor=machine.floor, tolerance=LEG, passes=MESHES)
    except AccuracyError:
        return None


def _lasts(machine: OneMass, theta: float, y: Values) -> float:
    """Angle [rad] over which the energy is spent at the rate at which it falls; infinite where it grows."""
    omega = _speed_at(machine, theta, y)
    load, viscous, quadratic = _loads_at(machine, theta)
    driving = y[-1] if machine.lag else machine.characteristic.moment(omega)
    net = float(driving + load + (viscous + quadratic * omega) * omega)
    return -float(y[0]) / net if net < 0 else np.inf


def _inertia_at(machine: OneMass, theta: Values) -> Values:
    """Total inertia at edges: the limit from within at either end of the cycle."""
    return machine.cycle.panels.at(machine.cycle.inertia, theta) + machine.constant


def _speed_at(machine: OneMass, theta: float, y: Values) -> float:
    """Angular speed [rad/s] at one angle in the state ``y`` (m,)."""
    return float(np.sqrt(2 * y[0] / _inertia_at(machine, np.array([theta]))[0]))


def _loads_at(machine: OneMass, theta: float) -> Values:
    """Moment, viscous and quadratic factor (3,) of the loads at one angle."""
    cycle = machine.cycle
    rows = np.stack((cycle.moment, cycle.viscous, cycle.quadratic))
    return cycle.panels.at(rows, np.array([theta]))[:, 0]


def _stopped(machine: OneMass, theta: float, y: Values, turn: int) -> Halt:
    """The end of a motion that no panel resolves: a stop if all moments on the way to standstill brake."""
    motor, pace = machine.characteristic, _speed_at(machine, theta, y) / machine.reference
    omega = machine.reference * np.append(SPEEDS[pace > SPEEDS], pace)
    load, viscous, quadratic = _loads_at(machine, theta)
    if pace < SLOW or np.all(motor.moment(omega) + load + (viscous + quadratic * omega) * omega < 0):
        return Halt(True, theta, turn)
    raise AccuracyError(
        f"the motion cannot be followed beyond {place(theta, machine.sense)} of cycle {turn}",
        where="steady motion",
        value=pace * machine.reference,
        remedy="mark the angle as a break of the load if it jumps there, or give the motor a less steep characteristic",
    )
