"""One call from a drive and a scenario to its transient motion."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.machine.transient.choice import plan
from tmmcalc.machine.transient.collocation import Collocation
from tmmcalc.machine.transient.equations import System
from tmmcalc.machine.transient.levels import RUNAWAY, Limits
from tmmcalc.machine.transient.methods import Method, habit
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.outcome import Curves, curves
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.run import Run
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.setup import Sizes, allowed, assembled, brake_mass, initial, sizes
from tmmcalc.machine.transient.steppers import Controlled, Stepper, fixed
from tmmcalc.machine.transient.verdicts import verdicts
from tmmcalc.machine.transient.ways import Ways

STEPS = 3_000  # that an asked error is spread over: a start seldom takes more
FINEST, COARSEST = 1e-13, 1e-4  # tolerances of a step


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
    ways = Ways(drive)
    shape = ways.forward
    chosen = plan(drive, scenario, shape, method)
    system = assembled(drive, scenario, shape, chosen.rigid)
    size = sizes(drive, system, scenario, shape)
    tolerance, left = _control(method, chosen.name, system)
    stepper = _stepper(chosen.name, method.step, [] if tolerance is None else allowed(system, size, tolerance))
    run = Run(system, ways, scenario, stepper, _limits(drive, scenario, system, size), size, method.budget)
    end = run.go(initial(system, scenario, ways.of(math.copysign(1.0, scenario.speed))), instants)
    found = curves(drive, system, ways, run.rows, brake_mass(drive, scenario))
    imbalance, given = _imbalance(found), drive.cycle.error if drive.cycle else 0.0
    return Transient(
        drive=drive,
        scenario=scenario,
        **{name: value for name, value in found._asdict().items() if name != "works"},
        motor_work=found.works[0],
        load_work=found.works[1],
        brake_work=found.works[2],
        shaft_loss=found.works[3],
        turning=np.array(run.turning).reshape(-1, 3).T,
        events=tuple(run.events),
        end=end,
        verdicts=verdicts(scenario, system, found, run.events, end, imbalance, chosen.notes, drive, shape),
        method=chosen.name,
        reason=chosen.reason,
        rigid=tuple(sorted(chosen.rigid)),
        imbalance=imbalance,
        error=max(imbalance, chosen.ripple, given, _estimate(tolerance, left, run, size)),
        counters={
            "steps": run.steps,
            "rejected": stepper.rejected,
            "evaluations": stepper.evaluations,
            "pieces": run.pieces,
        },
    )


def _control(method: Method, name: str, system: System) -> tuple[float | None, float]:
    """Tolerance of a step and what steps leave of it; None with fixed steps."""
    if method.step is not None:
        return None, 0.0
    used = habit(name, system.layout.works)
    if method.error:
        return min(max(method.error / (used.left * math.sqrt(STEPS)), FINEST), COARSEST), used.left
    return method.tolerance or used.tolerance, used.left


def _stepper(name: str, step: float | None, errors: list[float]) -> Stepper:
    if step is not None:
        return fixed(name, step)
    if name == "merson":
        return Controlled(errors)
    if name == "collocation":
        return Collocation(errors)
    from tmmcalc.machine.transient.library import Library

    return Library(name, errors)


def _estimate(tolerance: float | None, left: float, run: Run, size: Sizes) -> float:
    """Relative error of the speeds that the steps leave together; of fixed steps only Kutta-Merson tells its errors."""
    if tolerance is not None:
        return left * tolerance * math.sqrt(run.steps)
    layout = run.system.layout
    speeds = slice(layout.speed, layout.crank + 1)
    return sum(max(map(abs, row.error[speeds])) for row in run.rows if row.error) / size.speed


def _limits(drive: Drive, scenario: Scenario, system: System, size: Sizes) -> Limits:
    """Rated and critical speed of the motor, as speeds of the crank, and the speed at which it has run away."""
    motor, u = drive.characteristic, system.chain.motor_ratio
    runaway = RUNAWAY * size.speed if scenario.until_steady else None
    if motor is None:
        return Limits(None, None, runaway)
    nominal, critical = (None if s is None else s / u for s in (motor.nominal, motor.critical))
    return Limits(nominal, critical, runaway)


def _imbalance(found: Curves) -> float:
    """Largest difference between energy and work over the largest of all energies and works."""
    energy = found.kinetic + found.elastic
    turned = max(float(energy.max()), float(np.abs(found.works).max()))
    gap = float(np.abs(energy - energy[0] - found.works.sum(axis=0)).max())
    return gap / turned if turned else 0.0
