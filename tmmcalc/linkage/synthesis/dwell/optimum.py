"""The best parameters of a six-bar with a dwell: differential evolution over all that are not given, then a polish.

All candidates of a generation are synthesised and followed over their turns at once. A candidate that does not work is
counted under its reason; the first generation consists of candidates that work.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Real
from tmmcalc.core.progress import tell
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.dwell.criteria import rated
from tmmcalc.linkage.synthesis.dwell.parameters import NAMES, RANGES, drawn, given
from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Optimum
from tmmcalc.linkage.synthesis.dwell.turn import Turn, whole_turn
from tmmcalc.linkage.synthesis.results import SearchStep

if TYPE_CHECKING:
    from tmmcalc.linkage.synthesis.dwell.constraints import Rule

STEPS = 120  # of a turn
REFUSED = 1e9  # cost of a linkage that does not work
BATCHES = 30  # of random candidates for the first generation
DISTINCT = 0.1  # of the ranges: parameters that differ by less are one solution
EQUAL = 1e-8  # relative spread of the costs at which the evolution has converged


@record
class Optima:
    """The best rows of parameters, the best first, their costs, and how many candidates were refused for what."""

    rows: Real  # (k, 9)
    costs: Real  # (k,)
    tried: int
    worked: int
    refused: dict[str, int]
    course: tuple[SearchStep, ...]  # the generations, and the polish after them


class Costs:
    """Costs of candidates by the parameters that are free; it counts."""

    def __init__(self, asked: DwellTask, optimum: Optimum, rule: Rule | None = None) -> None:
        self.asked, self.weights, self.rule = asked, optimum.weights, rule
        self.values = given(asked)
        self.free = [k for k, name in enumerate(NAMES) if self.values[name] is None]
        self.bounds = np.array([optimum.ranges.get(NAMES[k], RANGES[NAMES[k]]) for k in self.free])
        self.fixed = np.array([0.5 if value is None else value for value in self.values.values()])
        self.tried = self.worked = 0
        self.best = REFUSED
        self.refused: Counter[str] = Counter()

    def rows(self, free: Real) -> Real:
        """Whole rows (m, 9) from the free parameters (m, p)."""
        rows = np.tile(self.fixed, (len(free), 1))
        rows[:, self.free] = free
        return rows

    def __call__(self, free: Real) -> Real:
        """Costs (m,) of free parameters (p, m) or (p,)."""
        rows = self.rows(np.atleast_2d(np.asarray(free).T))
        found = drawn(self.asked, rows)
        refused = np.any(list(found.faults.values()), axis=0)
        costs = np.full(len(rows), REFUSED)
        kept = np.flatnonzero(~refused)
        self.tried += len(rows)
        self._count(found.faults)
        if kept.size:
            turn = whole_turn(found.linkages.rows(kept), STEPS)
            self._count(turn.faults)
            self.worked += len(turn.which)
            if turn.which.size:
                which = kept[turn.which]
                costs[which] = self._of_working(turn, rows[which])
        self.best = min(self.best, float(costs.min(initial=REFUSED)))
        return costs if np.ndim(free) > 1 else costs[0]

    def _of_working(self, turn: Turn, rows: Real) -> Real:
        """Costs (k,) of the linkages of a turn with parameters (k, 9)."""
        traits = rated(turn, self.asked)
        costs = traits.criteria.cost(self.weights)
        if self.rule is None:
            return costs
        return self.rule.ranked(costs, turn, dict(zip(NAMES, rows.T, strict=True)), traits)

    def _count(self, faults: dict[str, np.ndarray]) -> None:
        for reason, flags in faults.items():
            self.refused[reason] += int(flags.sum())


def search(asked: DwellTask, optimum: Optimum, seed: int, count: int, rule: Rule | None = None) -> Optima:
    """The ``count`` best linkages that differ, those that keep the rule first.

    Raises `NoSolutionError` if no candidate works.
    """
    from scipy.optimize import differential_evolution

    costs = Costs(asked, optimum, rule)
    if not costs.free:
        row = costs.rows(np.zeros((1, 0)))
        return Optima(row, np.atleast_1d(costs(np.zeros((0, 1)))), 1, costs.worked, dict(costs.refused), ())
    first = _first(costs, optimum, np.random.default_rng(seed))
    course = [SearchStep(1, 0, costs.tried, costs.best)]

    def told(x: Real, convergence: float) -> None:
        done = len(course)
        course.append(SearchStep(1, done, costs.tried, costs.best))
        words = f"generation {done} of {optimum.generations}, cost {costs.best:.5g}, {costs.tried} linkages tried"
        tell(0.9 * done / optimum.generations, words)

    result = differential_evolution(
        costs,
        costs.bounds,
        maxiter=optimum.generations,
        init=first,
        seed=np.random.default_rng(seed),
        tol=EQUAL,
        atol=0.0,
        polish=False,
        updating="deferred",
        vectorized=True,
        callback=told,
    )
    best = _polished(costs, result.x, optimum.polish)
    course.append(SearchStep(2, len(course), costs.tried, costs.best))
    free, values = np.vstack((best, result.population)), np.append(costs(best[:, None]), result.population_energies)
    chosen = _distinct(costs, free, values, count)
    return Optima(
        costs.rows(free[chosen]), values[chosen], costs.tried, costs.worked, dict(costs.refused), tuple(course)
    )


def _first(costs: Costs, optimum: Optimum, rng: np.random.Generator) -> Real:
    """The first generation (m, p): random candidates that work."""
    low, high = costs.bounds.T
    kept: list[Real] = []
    for _ in range(BATCHES):
        free = rng.uniform(low, high, (optimum.population, len(low)))
        kept.extend(free[costs(free.T) < REFUSED])
        if len(kept) >= optimum.population:
            break
    least = 5  # that differential evolution needs
    if len(kept) < least:
        often = costs.refused.most_common(1)
        raise NoSolutionError(
            f"{len(kept)} of {costs.tried} random linkages work; most often: {often[0][0] if often else 'none'}",
            where="synthesis.dwell.optimum",
            value=float(len(kept)),
            limit=float(least),
            remedy="give fewer parameters, or wider ranges",
        )
    return np.array(kept[: optimum.population])


def _polished(costs: Costs, x: Real, evaluations: int) -> Real:
    """Nelder's and Mead's method from the best candidate, within the ranges."""
    if not evaluations:
        return x
    from scipy.optimize import minimize

    tell(0.9, "polish")
    start = np.vstack((x, x + np.diag(0.02 * np.ptp(costs.bounds, axis=1))))
    options = {"maxfev": evaluations, "initial_simplex": np.clip(start, *costs.bounds.T), "xatol": 1e-9, "fatol": 1e-12}
    return np.asarray(minimize(costs, x, method="Nelder-Mead", bounds=costs.bounds, options=options).x)


def _distinct(costs: Costs, free: Real, values: Real, count: int) -> list[int]:
    """Indices of the best candidates that work and differ."""
    part = (free - costs.bounds[:, 0]) / np.ptp(costs.bounds, axis=1)
    kept: list[int] = []
    for k in np.argsort(values, kind="stable").tolist():
        if values[k] < REFUSED and all(np.max(np.abs(part[k] - part[j])) > DISTINCT for j in kept):
            kept.append(k)
        if len(kept) == count:
            break
    return kept
