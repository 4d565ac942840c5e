"""Methods for the steady motion: collocation, shooting with every integrator, the methods of the textbook.

    collocation   the whole cycle at once on panels
    shooting      integrate one cycle from a speed, correct the speed until it repeats (secant)
    recurrence    textbook (3.57): the trapezoid rule for the work, whose periodic solution is direct

Of a motion without a motor:

    closed form   energy and work on panels, T0 by the mean speed
    energy        textbook (3.48): the same at nodes by the trapezoid rule, T0 = J(0) w_m^2/2 or corrected to the mean

The reference is the collocation, or the closed form, on panels cut in half once more, beside its own estimate. What is
compared are the speed at position 0 and the extremes of the speed over the cycle; of the textbook those of its nodes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.recurrence import on_nodes, periodic
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stages.motion import Asked, asked
from tmmcalc.machine.steady import driven
from tmmcalc.machine.transient.methods import Method, MethodName
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate

if TYPE_CHECKING:
    from tmmcalc.machine.cycle import Cycle
    from tmmcalc.machine.driver import Driver
    from tmmcalc.machine.regime import Regime

TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)
ASKED = (1e-3, 1e-6, 0.0)  # of the collocation; 0: near rounding
COUNTS = (6, 12, 24, 48, 96, 192, 384, 768, 1536, 3072)
SHOOTERS: tuple[MethodName, ...] = ("merson", "DOP853", "LSODA", "Radau", "BDF")
IMPLICIT = ("Radau", "BDF")  # of low order: their finest tolerance would take longer than all else
JUMPS = "of order 2 while the moments are smooth, of order 1 where a load jumps between or at its nodes"
FIRST = "begins at the mean speed, so that the mean that comes out is off however many nodes there are"
ROUNDS = 12  # of the secant
SETTLED = 1e-12  # relative change of the speed over a cycle that is none


def studies(scene: Scene) -> Iterator[Study]:
    """The speed over the cycle of a machine with a motor, or with a constant moment at a mean speed."""
    result: Motion = scene.results["motion"]
    reduction: Reduction = scene.results["reduction"]
    machine = asked(scene.inputs, scene.results)
    if result.kind == "positional":
        yield _without_motor(reduction.cycle, machine.inertia.total, result, scene)
    if machine.driver is None or result.kind != "motor":
        return
    problem = _Problem(reduction.cycle, machine, machine.driver)
    finest = problem.on_finer(result.regime)
    exact = _marks(finest)
    reference = Reference(
        f"collocation on {finest.panels.count} panels, each half of a panel of the stage", finest.error
    )

    def error(found: Values) -> float:
        return relative(found, exact)

    yield Study("motion", "speed at position 0, its extremes", reference, tuple(_series(problem, error, scene, result)))


def _without_motor(cycle: Cycle, inertia: float, result: Motion, scene: Scene) -> Study:
    """The closed form on panels, and the energy at nodes as on paper."""
    from tmmcalc.machine.byenergy import by_energy
    from tmmcalc.machine.onemass import onto
    from tmmcalc.machine.positional import positional

    mean, finer = result.regime.mean, result.regime.panels.halved()
    exact = positional(onto(cycle, finer), inertia, mean)
    marks = _marks(exact)

    def error(found: Values) -> float:
        return relative(found, marks)

    def nodal(count: int, corrected: bool) -> Values:
        omega = by_energy(cycle, inertia, mean, count, corrected=corrected).omega
        return np.array([omega[0], np.min(omega), np.max(omega)])

    def ways(corrected: bool) -> list[Way]:
        return [Way(f"{n} steps", 1.0 / n, partial(nodal, n, corrected)) for n in COUNTS]

    own = Way(f"{result.regime.panels.count} panels", None, lambda: _marks(positional(cycle, inertia, mean)))
    return Study(
        "motion",
        "speed at position 0, its extremes",
        Reference(f"closed form on {exact.panels.count} panels, each half of a panel of the stage", exact.error),
        (
            series("closed form on panels", [own], error, scene.clock),
            series("energy (3.48), T0 = J(0) w_m^2/2", ways(False), error, scene.clock, note=FIRST),
            series("energy (3.48), T0 by the mean", ways(True), error, scene.clock, expected=2.0, note=JUMPS),
        ),
    )


class _Problem:
    """The machine whose regime is sought; speeds are given back as (3,): at position 0, the least, the largest."""

    def __init__(self, cycle: Cycle, machine: Asked, driver: Driver) -> None:
        self.cycle, self.inertia, self.driver = cycle, machine.inertia.total, driver

    def regime(self, tolerance: float) -> Values:
        """By collocation."""
        motor = self.driver
        found = driven(
            self.cycle, self.inertia, motor.characteristic, time_constant=motor.time_constant, tolerance=tolerance
        )
        return _marks(found)

    def on_finer(self, regime: Regime) -> Regime:
        """The regime on halved panels."""
        from tmmcalc.machine.onemass import onto

        motor = self.driver
        return driven(
            onto(self.cycle, regime.panels.halved()),
            self.inertia,
            motor.characteristic,
            time_constant=motor.time_constant,
        )

    def shot(self, name: MethodName, tolerance: float, start: float) -> Values:
        """By integration of cycles, from ``start`` [rad/s] on, until one repeats."""
        drive = Drive((Mass(self.inertia),), (), self.driver.characteristic, self.cycle)
        method, period = Method(name, tolerance=tolerance, compared=False), self.cycle.period

        def gap(speed: float) -> tuple[float, Values]:
            scenario = Scenario("cycle", 20 * period / speed, speed, settled=True, end_angle=period)
            run = simulate(drive, scenario, method)
            last = float(run.omega[-1, -1])
            passed = [speed, last, *run.turning[2].tolist()]
            return last * last - speed * speed, np.array([speed, min(passed), max(passed)])

        return _secant(gap, start)

    def recurred(self, a: float, b: float, count: int) -> Values:
        """By the recurrence on ``count`` equal steps."""
        omega = periodic(on_nodes(self.cycle, self.inertia, a, b, count)).omega
        return np.array([omega[0], np.min(omega), np.max(omega)])


def _marks(regime: Regime) -> Values:
    return np.array([regime.omega_at(np.zeros(1))[0], regime.omega_min, regime.omega_max])


def _series(problem: _Problem, error: Callable[[Values], float], scene: Scene, result: Motion) -> Iterator[Series]:
    ways = [
        Way("near rounding" if not t else f"tolerance {t:.0e}", t or 1e-13, partial(problem.regime, t)) for t in ASKED
    ]
    yield series("collocation", ways, error, scene.clock, stepwise=False)
    if problem.driver.time_constant == 0:
        start = float(result.regime.omega_at(np.zeros(1))[0]) * 1.02
        for name in SHOOTERS:
            tolerances = TOLERANCES[:-1] if name in IMPLICIT else TOLERANCES
            ways = [Way(f"tolerance {t:.0e}", t, partial(problem.shot, name, t, start)) for t in tolerances]
            yield series(f"shooting, {name}", ways, error, scene.clock, stepwise=False)
    if result.textbook is not None:
        a, b = result.textbook.a, result.textbook.b
        ways = [Way(f"{n} steps", 1.0 / n, partial(problem.recurred, a, b, n)) for n in COUNTS]
        yield series("recurrence (3.57)", ways, error, scene.clock, expected=2.0, note=JUMPS)


def _secant(gap: Callable[[float], tuple[float, Values]], start: float) -> Values:
    """Speeds of the cycle that repeats: the map of the squared speed is nearly affine, so a few secants do."""
    squares, gaps = [], []
    square = start * start
    for _ in range(ROUNDS):
        if square <= 0:
            break
        missed, speeds = gap(math.sqrt(square))
        squares.append(square)
        gaps.append(missed)
        if abs(missed) <= SETTLED * square:
            return speeds
        if len(gaps) == 1:
            square += missed
            continue
        fall = (gaps[-1] - gaps[-2]) / (squares[-1] - squares[-2]) if squares[-1] != squares[-2] else 0.0
        if fall == 0 or (len(gaps) > 3 and abs(gaps[-1]) >= abs(gaps[-2])):
            return speeds  # as near as its steps allow
        square -= missed / fall
    raise NoSolutionError("shooting does not settle", where="accuracy, motion")
