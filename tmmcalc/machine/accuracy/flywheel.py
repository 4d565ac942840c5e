"""Methods for the inertia that keeps the allowed unevenness: search on the true motion, corrections, tangents, tables.

    search        the program's: bracketed secants in (J^2, 1/delta^2) on the steady motion under the motor
    bisection     the same motion, halving a bracket
    correction    the textbook's J := J delta/[delta] (3.60), run after run
    tangents      Wittenbauer's energy-mass curve, Mertsalov and others, for forces of position: what they leave out of
                  the motor's speed stays as an error of the method
    table         Wittenbauer's by the textbook (3.53) on the nodes of a table

The reference is Brent's method on the motion on panels cut in half; without a motor the exact tangents there. What is
compared are the inertia, and the unevenness that the machine reaches with it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.studies.measure import Way, by_quantity, relative
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import Driver
from tmmcalc.machine.flywheel.curve import energy_curve
from tmmcalc.machine.flywheel.methods import nodal_flywheels
from tmmcalc.machine.flywheel.required import fluctuation, required_inertia
from tmmcalc.machine.flywheel.resimulation import motions
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.search import Model, corrections
from tmmcalc.machine.flywheel.wittenbauer import METHODS, Rule, tangents
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.stages.flywheel import asked

BOOK = 1  # place of the textbook's method among all
RUNS = (1, 2, 3, 4, 6, 8, 12)  # of the textbook's correction
HALVINGS = (5, 10, 20, 30, 40)
COUNTS = (6, 12, 24, 48, 96, 192, 384, 768)
WIDE = 4.0  # times the root: where bisection begins
LEFT = "what is left is the error of the method itself: it takes the motor's moment as constant"

Missed = Callable[[float], float]  # error by the inertia found


def studies(scene: Scene) -> Iterator[Study]:
    """The inertia and the unevenness reached; nothing for a machine that needs no flywheel."""
    result: Flywheel = scene.results["flywheel"]
    if result.addition <= 0:
        return
    machine = asked(scene.inputs, scene.results)
    cycle, speed = scene.results["reduction"].cycle, _speed(result, machine.speed)
    problem = _Problem(cycle, machine.at_hand.total, machine.driver, result.delta, speed)
    exact, own = problem.reference()
    name = "Brent's method" if machine.driver is not None else "exact tangents"
    name = f"{name} on panels cut in half"

    def missed_inertia(inertia: float) -> float:
        return relative(inertia, exact)

    def missed_delta(inertia: float) -> float:
        return relative(problem.reached(inertia), result.delta)

    inertias, deltas = zip(*_series(problem, (missed_inertia, missed_delta), scene), strict=True)
    yield Study("flywheel", "constant inertia needed", Reference(name, own), inertias)
    yield Study("flywheel", "unevenness reached", Reference(name, max(own, missed_delta(exact))), deltas)


def _speed(result: Flywheel, given: float) -> float:
    """The mean speed that the methods for forces of position are told [rad/s]."""
    return result.required.regime.mean if result.required is not None else given


class _Problem:
    """The machine whose least constant inertia [kg*m^2] for an unevenness is sought."""

    def __init__(self, cycle: Cycle, at_hand: float, driver: Driver | None, delta: float, speed: float) -> None:
        self.cycle, self.at_hand, self.driver, self.delta, self.speed = cycle, at_hand, driver, delta, speed
        self._finer = onto(cycle, cycle.panels.halved())
        self._reached = self.model(self._finer)

    def model(self, cycle: Cycle) -> Model:
        """The function inertia -> unevenness of a cycle; under forces of position that of the exact motion."""
        if self.driver is not None:
            return fluctuation(cycle, self.driver.characteristic, self.driver.time_constant)
        curve, speed = energy_curve(cycle, self.speed), self.speed

        def delta(inertia: float) -> float | None:
            found = motions(curve, np.array([inertia]), speed)
            return float(found.spread[0]) / speed if found.exists[0] else None

        return delta

    def reached(self, inertia: float) -> float:
        """Unevenness with an inertia on the finer panels; 1 where the machine does not run with it."""
        found = self._reached(inertia)
        return 1.0 if found is None else found

    def reference(self) -> tuple[float, float]:
        """The inertia, and how far that on the panels of the stage is from it, relative."""
        if self.driver is None:
            exact, rough = (self._tangent(METHODS[0], cycle) for cycle in (self._finer, self.cycle))
        else:
            near = self.search()
            exact, rough = (self._root(self.model(cycle), near) for cycle in (self._finer, self.cycle))
        return exact, relative(rough, exact)

    def _root(self, model: Model, near: float) -> float:
        from scipy.optimize import brentq

        def gap(inertia: float) -> float:
            found = model(inertia)
            return 1.0 if found is None else found / self.delta - 1

        return float(brentq(gap, near / 1.01, near * 1.01, xtol=1e-15 * near, rtol=1e-14))

    def search(self) -> float:
        """By the program's search."""
        assert self.driver is not None
        motor, lag = self.driver.characteristic, self.driver.time_constant
        return required_inertia(self.cycle, motor, self.delta, self.at_hand, lag).inertia

    def bisected(self, halvings: int) -> float:
        """By halving a bracket about Mertsalov's inertia."""
        model, middle = self.model(self.cycle), max(self.tangent(METHODS[2]), self.at_hand)
        low, high = middle / WIDE, middle * WIDE
        for _ in range(halvings):
            middle = (low * high) ** 0.5
            found = model(middle)
            low, high = (low, middle) if found is not None and found <= self.delta else (middle, high)
        return high

    def corrected(self, runs: int) -> float:
        """By the textbook's correction, from the inertia at hand on."""
        if self.at_hand <= 0:
            raise NoSolutionError("there is no constant inertia to correct", where="flywheel, correction (3.60)")
        return corrections(self.model(self.cycle), self.delta, self.at_hand, tolerance=0.0, limit=runs)[-1].inertia

    def tangent(self, rule: Rule) -> float:
        """By two tangents of the energy-mass curve, on panels."""
        return self._tangent(rule, self.cycle)

    def _tangent(self, rule: Rule, cycle: Cycle) -> float:
        return float(tangents(energy_curve(cycle, self.speed), self.delta, self.speed, (rule,)).inertia[0])

    def tabled(self, count: int) -> float:
        """By the textbook's method on the nodes of a table."""
        moment, inertia = nodal_tables(self.cycle, count, self.speed)
        work, _ = nodal_work(moment, self.cycle.period)
        return nodal_flywheels(work, inertia, 0.0, self.delta, self.speed, period=self.cycle.period)[BOOK].inertia


def _series(problem: _Problem, errors: tuple[Missed, Missed], scene: Scene) -> Iterator[tuple[Series, ...]]:
    clock, driven = scene.clock, problem.driver is not None
    if driven:
        yield by_quantity("search", [Way("near rounding", None, problem.search)], errors, clock)
        ways = [Way(f"{n} runs", 2.0**-n, partial(problem.bisected, n)) for n in HALVINGS]
        yield by_quantity("bisection", ways, errors, clock, expected=(1.0, 1.0))
        ways = [Way(f"{n} runs", None, partial(problem.corrected, n)) for n in RUNS]
        yield by_quantity("correction (3.60)", ways, errors, clock, note="it approaches the inertia from below")
    for rule in METHODS:
        ways = [Way("on panels", None, partial(problem.tangent, rule))]
        yield by_quantity(
            f"tangents, {rule.name}", ways, errors, clock, note=LEFT if driven and rule is METHODS[0] else ""
        )
    ways = [Way(f"{n} steps", 1.0 / n, partial(problem.tabled, n)) for n in COUNTS]
    yield by_quantity("table, book", ways, errors, clock)
