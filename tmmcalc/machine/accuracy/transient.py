"""Methods for motions in time: Kutta-Merson and Runge-Kutta with fixed steps, and all methods with step control.

The reference is collocation, an implicit method of order 13, at its finest tolerance; another run beside it says how
good it is, and the other methods, which come as near to it as their tolerances promise, confirm it.
What is compared are the speeds of all masses at equal instants up to the end of the motion, relative to the largest.
A method that needs more than the budget of evaluations, or whose step is unstable, is kept with its reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Ladder, Reference, Series, Study
from tmmcalc.machine.accuracy.ladder import ladders, speeds
from tmmcalc.machine.stages.shaft import mean_speed
from tmmcalc.machine.stages.transient import machine_of
from tmmcalc.machine.transient.methods import Method, MethodName
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate
from tmmcalc.machine.transient.solve import beginning
from tmmcalc.machine.transient.timed import TimedMotion

TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10)
CONTROLLED: tuple[MethodName, ...] = ("merson", "collocation", "DOP853", "LSODA", "Radau", "BDF")
IMPLICIT = ("Radau", "BDF")  # of scipy: their finest tolerance would take longer than all else
STEPS = (0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125, 0.0006, 0.0003)  # [s], the textbook takes 0.01 to 0.04
FIXED: tuple[tuple[MethodName, float], ...] = (("merson", 4.0), ("rk4", 4.0))
FINEST = (1e-11, 1e-12)
INSTANTS = 64
BUDGET = 40_000  # evaluations after which a method is given up


def studies(scene: Scene) -> Iterator[Study | Ladder]:
    """The speeds of every motion that the scene asks for, and the first one on ladders of stiffness."""
    machine, tasks = machine_of(scene.inputs, scene.results), scene.inputs[0]
    speed = mean_speed(scene.results, scene.inputs[3])
    motions, begun = scene.results["transient"].motions, beginning(machine, tasks, speed)
    for (drive, scenario), found in zip(begun, motions, strict=True):
        yield _study(drive, scenario, found, scene)
    yield from ladders(*begun[0], scene.clock)


def _study(drive: Drive, scenario: Scenario, found: TimedMotion, scene: Scene) -> Study:
    instants = np.linspace(0.0, float(found.t[-1]), INSTANTS + 1)[1:-1]

    def run(method: Method) -> Transient:
        return simulate(drive, scenario, method, instants.tolist())

    first, finest = (speeds(run(Method("collocation", tolerance=t, compared=False)), instants) for t in FINEST)
    own = relative(first, finest)

    def error(motion: Transient) -> float:
        return relative(speeds(motion, instants), finest)

    name = f"collocation of order 13 at a tolerance of {FINEST[1]:g}, beside {FINEST[0]:g}"
    return Study("transient", f"speeds, {found.name}", Reference(name, own), tuple(_series(run, error, scene)))


def _series(run: Callable[[Method], Transient], error: Callable[[Transient], float], scene: Scene) -> Iterator[Series]:
    for name in CONTROLLED:
        ways = [
            Way(
                f"tolerance {t:.0e}",
                t,
                partial(run, Method(name, tolerance=t, budget=BUDGET, compared=False)),
                _evaluations,
            )
            for t in (TOLERANCES[:-1] if name in IMPLICIT else TOLERANCES)
        ]
        yield series(name, ways, error, scene.clock, stepwise=False)
    for name, order in FIXED:
        ways = [Way(f"step {1e3 * h:g} ms", h, partial(run, _fixed(name, h)), _evaluations) for h in STEPS]
        yield series(f"{name}, fixed steps", ways, error, scene.clock, expected=order)


def _fixed(name: MethodName, step: float) -> Method:
    """Fixed steps alone, without the second run that tells their error."""
    return Method(name, step=step, budget=BUDGET, compared=False)


def _evaluations(motion: Transient) -> int:
    return motion.counters["evaluations"]
