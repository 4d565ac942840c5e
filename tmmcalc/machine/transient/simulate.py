"""One call from a drive and a scenario to its transient motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple, cast

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.machine.motors.gearing import pole_of
from tmmcalc.machine.transient.collocation import Collocation
from tmmcalc.machine.transient.equations import System
from tmmcalc.machine.transient.errors import FEW, instants_of, missed, second
from tmmcalc.machine.transient.errors import left as left_of
from tmmcalc.machine.transient.extremes import Found
from tmmcalc.machine.transient.initial import Sizes, allowed, assembled, brake_mass, initial, sizes
from tmmcalc.machine.transient.largest import largest_moments
from tmmcalc.machine.transient.levels import RUNAWAY, Limits
from tmmcalc.machine.transient.methodchoice import plan
from tmmcalc.machine.transient.methods import Method, MethodName, habit
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.outcome import Curves, curves
from tmmcalc.machine.transient.profile import Profiles
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.run import Run
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.steppers import Controlled, Stepper, fixed
from tmmcalc.machine.transient.verdicts import verdicts

STEPS = 3_000  # that an asked error is spread over: a start seldom takes more
FINEST, COARSEST = 1e-13, 1e-4  # tolerances of a step
BETTER = 0.1  # part of an asked error that is asked of the run which tells that of fixed steps
RETRIES, AIMED = 4, 0.5  # runs that an asked error is given, and the part of it that the next one aims at


def simulate(
    drive: Drive, scenario: Scenario, method: Method | None = None, instants: Sequence[float] = ()
) -> Transient:
    """The transient motion of a drive; rows at every step and at the ``instants`` [s].

    Raises `UsageError` for a drive that cannot be reduced, `AccuracyError` where a method does not keep its tolerance
    or its budget. A motor that cannot start or is brought to rest is no error: the run ends there, with a
    verdict. Source: textbook section 3.4.4, program 2.3.

    >>> from tmmcalc.machine.transient.model import Mass
    >>> from tmmcalc.machine.transient.scenario import Brake
    >>> run = simulate(Drive((Mass(2.0),)), Scenario("run-down", 1.0, speed=10.0, brake=Brake(moment=40.0)))
    >>> run.end, round(float(run.t[-1]), 12)
    ('standstill', 0.5)
    """
    method = method or Method()
    if method.step is not None:
        return _in_fixed_steps(drive, scenario, method, instants)
    aim = method.error
    for _ in range(RETRIES):
        found, guess = _integrated(drive, scenario, method, instants, aim)
        left, moments = _left(found, guess, method) if method.compared else (guess.error, guess.error)
        worst = max(left, moments + found.extremes_error)
        if worst <= method.error or not aim or guess.tolerance <= FINEST:
            break
        aim *= AIMED * method.error / worst
    return _with_errors(found, left, moments)


class _Guess(NamedTuple):
    """What the steps of a run may leave."""

    error: float  # relative error of the speeds; of rk4 in fixed steps, which does not tell, 0
    tolerance: float  # of a step; 0: fixed
    allowed: float  # error of the speeds in a step, relative to the largest


def _with_errors(found: Transient, speeds: float, moments: float) -> Transient:
    """The motion with the errors that its steps leave of the speeds and of the largest moments."""
    error = max(found.error, speeds)
    return replace(found, error=error, extremes_error=moments + found.extremes_error)


def _left(found: Transient, guess: _Guess, method: Method) -> tuple[float, float]:
    """Relative error of speeds and largest moments that steps leave, by a second run; where it fails as guessed."""
    tolerance, times = second(found.method, guess.tolerance), instants_of(found, FEW)
    other = Method(cast(MethodName, found.method), tolerance=tolerance, budget=method.budget)
    try:
        again, _ = _integrated(found.drive, found.scenario, other, times, 0.0, frozenset(found.rigid))
    except AccuracyError:
        return guess.error, guess.error
    return left_of(found, again, guess.tolerance, guess.allowed)


def _in_fixed_steps(drive: Drive, scenario: Scenario, method: Method, instants: Sequence[float]) -> Transient:
    """The motion in fixed steps, its error from a second run with step control if the method asks for it."""
    found, guess = _integrated(drive, scenario, method, instants, 0.0)
    if not method.compared:
        return _with_errors(found, guess.error, guess.error)
    better = Method(budget=method.budget, error=BETTER * method.error, compared=False)
    controlled = simulate(drive, scenario, better, instants_of(found))
    return _with_errors(found, *missed(found, controlled))


def _integrated(
    drive: Drive,
    scenario: Scenario,
    method: Method,
    instants: Sequence[float],
    aim: float,
    rigid: frozenset[int] | None = None,
) -> tuple[Transient, _Guess]:
    """The motion by one method, its error but for that of the steps, which is guessed beside it."""
    ways = Profiles(drive)
    shape = ways.forward
    chosen = plan(drive, scenario, shape, method, rigid)
    system = assembled(drive, scenario, shape, chosen.rigid)
    size = sizes(drive, system, scenario, shape)
    tolerance, left = _control(method, chosen.name, system, aim)
    stepper = _stepper(chosen.name, method.step, [] if tolerance is None else allowed(system, size, tolerance))
    run = Run(system, ways, scenario, stepper, _limits(drive, scenario, system, size), size, method.budget)
    end = run.go(initial(system, scenario, ways.of(math.copysign(1.0, scenario.speed))), instants)
    found = curves(drive, system, ways, run.rows, brake_mass(drive, scenario))
    moments = largest_moments(drive, found, run)
    imbalance, given = _imbalance(found), drive.cycle.error if drive.cycle else 0.0
    largest = float(np.abs(found.omega / np.array(system.chain.ratio)[:, None]).max()) or size.speed
    allowance = (tolerance or 0.0) * size.speed / largest
    guess = _Guess(_estimate(tolerance, left, run, size) / largest, tolerance or 0.0, allowance)
    motion = Transient(
        drive=drive,
        scenario=scenario,
        **found.rows(),
        largest_moment=np.array([(each.value, each.time) for each in moments]).T,
        turning=np.array(run.turning).reshape(-1, 3).T,
        events=tuple(run.events),
        end=end,
        verdicts=verdicts(scenario, system, found, run.events, end, imbalance, chosen.notes, drive, shape),
        method=chosen.name,
        reason=chosen.reason,
        scales=chosen.scales,
        rigid=tuple(sorted(chosen.rigid)),
        imbalance=imbalance,
        error=max(chosen.ripple / largest, given),
        extremes_error=_gap(moments),
        counters=run.counters,
    )
    return motion, guess


def _gap(moments: list[Found]) -> float:
    """What interpolation may miss of the largest moments, relative to each; at most all of it."""
    return max(each.gap / max(abs(each.value), each.gap) if each.gap else 0.0 for each in moments)


def _control(method: Method, name: str, system: System, aim: float) -> tuple[float | None, float]:
    """Tolerance of a step and what steps leave of it, if they are to leave the error ``aim``; None of fixed steps."""
    if method.step is not None:
        return None, 0.0
    used = habit(name, system.layout.works)
    if aim:
        return min(max(aim / (used.left * math.sqrt(STEPS)), FINEST), COARSEST), used.left
    return method.tolerance or used.tolerance, used.left


def _stepper(name: str, step: float | None, errors: list[float]) -> Stepper:
    if step is not None:
        return fixed(name, step)
    if name == "merson":
        return Controlled(errors)
    if name == "collocation":
        return Collocation(errors)
    from tmmcalc.machine.transient.scipymethods import Library

    return Library(name, errors)


def _estimate(tolerance: float | None, left: float, run: Run, size: Sizes) -> float:
    """Error of the speeds [rad/s] that the steps leave together; 0 of rk4 in fixed steps, which does not tell."""
    if tolerance is not None:
        return left * tolerance * math.sqrt(run.steps) * size.speed
    speeds = slice(run.system.layout.speed, run.system.layout.crank + 1)
    return sum(max(map(abs, row.error[speeds])) for row in run.rows if row.error)


def _limits(drive: Drive, scenario: Scenario, system: System, size: Sizes) -> Limits:
    """Rated and critical speed of the motor, as speeds of the crank, and the speed at which it has run away."""
    motor, u = drive.characteristic, system.chain.motor_ratio
    runaway = RUNAWAY * size.speed if scenario.until_steady else None
    if motor is None:
        return Limits(None, None, runaway)
    nominal, critical, pole = (None if s is None else s / u for s in (motor.nominal, motor.critical, pole_of(motor)))
    return Limits(nominal, critical, runaway, pole)


def _imbalance(found: Curves) -> float:
    """Largest difference between energy and work over the largest of all energies and works."""
    energy = found.kinetic + found.elastic
    turned = max(float(energy.max()), float(np.abs(found.works).max()))
    gap = float(np.abs(energy - energy[0] - found.works.sum(axis=0)).max())
    return gap / turned if turned else 0.0
