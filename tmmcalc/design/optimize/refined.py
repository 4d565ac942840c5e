"""What evolution has found, made better by local searches: its hollows, the best of them, or all designs of a front."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.design.optimize.evolution import Population
from tmmcalc.design.optimize.order import better, ranked
from tmmcalc.design.optimize.polish import LONGEST, SHORTER, Aim, polish
from tmmcalc.design.optimize.problem import Problem

Values = NDArray[np.floating[Any]]

LEAST, HOLLOWS = 8, 12  # hollows that are polished where designs break constraints, and at most
WORTH = 5000  # designs of evolution that each is worth
SEEN, APART = 5000, 0.1  # best designs, how far from each other some are (of the box)
NEAR = 64  # sets of listed values about the best that are tried


def of_hollows(problem: Problem, found: Population, budget: int) -> Population:
    """The best of local searches from the best designs that are far from each other; the best of evolution with them.

    What evolution leaves is in one hollow; another one may be deeper. Designs that break constraints are led to keep
    them.
    """
    scores = problem.judged(problem.results)
    broken = found.scores.violation[0] > 0
    most = LEAST if broken else int(np.clip(budget // WORTH, 1, HOLLOWS))
    chosen: list[Values] = []
    for number in ranked(scores)[:SEEN].tolist():
        part = problem.parts(problem.values[number])
        if np.isfinite(scores.violation[number]) and all(np.abs(part - other).max() > APART for other in chosen):
            chosen.append(part)
        if len(chosen) == most:
            break
    if not chosen:
        return Population(found.places[:1], found.scores[:1])
    aims = [Aim(0, np.full(len(problem.objectives), np.inf))] * len(chosen)
    ends = polish(problem, np.array(chosen), aims, SHORTER)
    every = Population(ends.places, ends.scores).with_more(Population(found.places[:1], found.scores[:1]))
    return Population(every.places[:1], every.scores[:1])


def polished(problem: Problem, best: Population, budget: int) -> Population:
    """The best design by local search; listed values are changed to their neighbours while that makes it better."""
    free = np.full(len(problem.objectives), np.inf)
    found = polish(problem, best.places[:1], [Aim(0, free)], _longest(problem, budget))
    here = Population(found.places, found.scores)
    while problem.discrete:
        starts = _neighbours(problem, here.places[0])
        if not len(starts):
            return here
        found = polish(problem, starts, [Aim(0, free)] * len(starts))
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
            aims.append(Aim(ends[number], np.full(several, np.inf)))
        else:
            caps = front.scores.objectives[number].copy()
            caps[0] = np.inf
            aims.append(Aim(0, caps))
    found = polish(problem, front.places, aims)
    return Population(found.places, found.scores)


def _longest(problem: Problem, budget: int) -> int:
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
