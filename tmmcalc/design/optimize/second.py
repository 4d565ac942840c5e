"""A second method with as many designs, by its own random numbers: whether it finds the same."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.optimize.evolution import Population, population, spread
from tmmcalc.design.optimize.order import Scores, ranked
from tmmcalc.design.optimize.polish import LONGEST, Aim, Locals, polish
from tmmcalc.design.optimize.problem import Problem
from tmmcalc.design.optimize.refined import longest_of, polished
from tmmcalc.design.optimize.starts import LEAST, MOST, apart, free, hits, searched

Values = NDArray[np.floating[Any]]

BRIEF = 100  # designs a variable that each local search may ask for at least
DRAWN = 16, 0.25  # random designs: so many for the least number of starts, or this part of what may be solved


@record
class Second:
    """What a second method found, of each objective by itself."""

    method: str
    best: tuple[float, ...]  # inf where it found nothing
    hits: tuple[int, ...] = ()  # of its local searches that found the best, within EQUAL
    starts: int = 0  # the designs that these began from, for each objective; 0: it is no local search
    drawn: int = 0  # of so many random ones
    better: tuple[bool, ...] = ()  # than the first, by more than EQUAL
    worse: tuple[bool, ...] = ()


def second_method(problem: Problem, budget: int, seed: int) -> tuple[Second, Population]:
    """Another method with as many designs, on its own random numbers."""
    if problem.discrete:
        return _by_scipy(problem, budget, seed)
    return _by_starts(problem, budget, seed)


def _by_starts(problem: Problem, budget: int, seed: int) -> tuple[Second, Population]:
    """Local searches from the best of many random designs that are far from each other, in turns for each objective."""
    variables, several = len(problem.variables), len(problem.objectives)
    drawn = spread(variables, max(LEAST * DRAWN[0], int(budget * DRAWN[1])), seed + 1)
    scores = problem.scores(drawn)
    chosen: list[tuple[int, int, Values]] = []
    for at in range(several):
        order = ranked(Scores(scores.objectives[:, [at]], scores.violation))
        own = apart(drawn[order[np.isfinite(scores.violation[order])]], MOST // several)
        chosen += [(rank, at, place) for rank, place in enumerate(own)]
    chosen.sort(key=lambda each: each[:2])
    method = "sequential quadratic programming from random designs"
    if not chosen:
        return Second(method, (np.inf,) * several, (0,) * several), Population(drawn[:0], scores[:0])
    aims = [free(problem, at) for _, at, _ in chosen]
    longest = int(np.clip(budget // (LEAST * variables), BRIEF, LONGEST))
    found = searched(problem, np.array([place for *_, place in chosen]), aims, longest, budget, LEAST)
    begun = len(found.places)
    found, aims = _finished(problem, found, aims[:begun], longest_of(problem, budget))
    best, agreeing = hits(problem, found, aims)
    kept = found.scores.violation == 0
    second = Second(method, best, agreeing, -(-begun // several), len(drawn))
    return second, Population(found.places[kept], found.scores[kept])


def _finished(problem: Problem, found: Locals, aims: Sequence[Aim], longest: int) -> tuple[Locals, list[Aim]]:
    """The ends of searches, those that are the best for their objective in the place of where they have gone on to."""
    places, scores = found.places.copy(), found.scores
    tops = []
    for at in range(len(problem.objectives)):
        own = np.array([aim.objective == at for aim in aims], bool)
        order = ranked(Scores(scores.objectives[:, [at]], scores.violation))
        tops += order[own[order]][:1].tolist()
    more = polish(problem, places[tops], [aims[top] for top in tops], longest)
    places[tops] = more.places
    return Locals(places, problem.scores(places)), [*aims]


def _by_scipy(problem: Problem, budget: int, seed: int) -> tuple[Second, Population]:
    """Of each objective by itself scipy's differential evolution, polished."""
    from scipy.optimize import differential_evolution

    size = max(5, population(len(problem.variables), budget) // len(problem.variables))
    places, best = [], []
    for at in range(len(problem.objectives)):

        def cost(x: Values, at: int = at) -> Values:
            scores = problem.scores(np.atleast_2d(x.T))
            own, broken = scores.objectives[:, at], scores.violation
            worst = np.max(np.abs(own[np.isfinite(own)]), initial=1.0)
            penalty = np.where(np.isfinite(broken), broken, 1e6)
            return np.where(broken > 0, worst * (10 + penalty), own)

        found = differential_evolution(
            cost,
            [(0.0, 1.0)] * len(problem.variables),
            vectorized=True,
            updating="deferred",
            polish=False,
            seed=seed + 1 + at,
            popsize=size,
            maxiter=max(1, budget // (size * len(problem.variables)) - 1),
            tol=0.0,
            atol=0.0 if problem.free else 1e-12,
        )
        place = found.x[None]
        here = Population(place, problem.scores(place))
        if len(problem.objectives) == 1 and here.scores.violation[0] == 0:
            here = polished(problem, here, budget)
        places.append(here.places[0])
        best.append(float(here.scores.objectives[0, at]) if here.scores.violation[0] == 0 else np.inf)
    stack = np.array(places)
    scores = problem.scores(stack)
    kept = scores.violation == 0
    return Second("scipy's differential evolution", tuple(best)), Population(stack[kept], scores[kept])
