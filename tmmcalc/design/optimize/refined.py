"""What evolution has found, made better by local searches: its hollows, the best of them, or all designs of a front."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.design.optimize.evolution import Population
from tmmcalc.design.optimize.order import better, ranked
from tmmcalc.design.optimize.polish import LONGEST, SHORTER, Aim, polish
from tmmcalc.design.optimize.problem import Problem
from tmmcalc.design.optimize.starts import LEAST, MOST, apart, free, searched

Values = NDArray[np.floating[Any]]

NEAR = 64  # sets of listed values about the best that are tried


def of_hollows(problem: Problem, found: Population, budget: int) -> Population:
    """The best of local searches from the best designs that are far from each other; the best of evolution with them.

    What evolution leaves is in one hollow; another one may be deeper, and how good a design is tells little of how deep
    its hollow goes. So each search goes on to its end, and there are as many as ``budget`` designs are enough for.
    Designs that break constraints are led to keep them.
    """
    scores = problem.judged(problem.results)
    order = ranked(scores)
    places = problem.parts(problem.values[order[np.isfinite(scores.violation[order])]])
    longest, left = longest_of(problem, budget), budget
    if found.scores.violation[0] > 0:
        longest, left = SHORTER, LEAST * SHORTER * len(problem.variables)
    starts = apart(places, MOST)
    ends = searched(problem, starts, [free(problem, 0)] * len(starts), longest, left)
    every = Population(ends.places, ends.scores).with_more(Population(found.places[:1], found.scores[:1]))
    return Population(every.places[:1], every.scores[:1])


def polished(problem: Problem, best: Population, budget: int) -> Population:
    """The best design by local search; listed values are changed to their neighbours while that makes it better."""
    found = polish(problem, best.places[:1], [free(problem, 0)], longest_of(problem, budget))
    here = Population(found.places, found.scores)
    while problem.discrete:
        starts = _neighbours(problem, here.places[0])
        if not len(starts):
            return here
        found = polish(problem, starts, [free(problem, 0)] * len(starts))
        at = int(ranked(found.scores)[0])
        if not better(found.scores[[at]], here.scores)[0]:
            return here
        here = Population(found.places[[at]], found.scores[[at]])
    return here


def polished_front(problem: Problem, front: Population) -> Population:
    """Every design of a front by local search: its ends for their own objective, the others with all but one held."""
    count, several = front.scores.objectives.shape
    ends = {int(np.argmin(front.scores.objectives[:, at])): at for at in range(several)}
    aims = []
    for number in range(count):
        if number in ends:
            aims.append(free(problem, ends[number]))
        else:
            caps = front.scores.objectives[number].copy()
            caps[0] = np.inf
            aims.append(Aim(0, caps))
    found = polish(problem, front.places, aims)
    return Population(found.places, found.scores)


def longest_of(problem: Problem, budget: int) -> int:
    """Designs a variable that a local search of the best may ask for."""
    return int(np.clip(budget // len(problem.variables), SHORTER, LONGEST))


def _neighbours(problem: Problem, place: Values) -> Values:
    """Designs with listed values next to these, one or two of them changed."""
    changes = [(k, step / len(problem.variables[k].among)) for k in problem.discrete for step in (-1, 1)]
    moves = [[one] for one in changes] + [
        [one, two] for at, one in enumerate(changes) for two in changes[at + 1 :] if one[0] != two[0]
    ]
    found = []
    for move in moves[:NEAR]:
        other = place.copy()
        for k, step in move:
            other[k] += step
        if ((other >= 0) & (other <= 1)).all():
            found.append(other)
    return np.array(found)
