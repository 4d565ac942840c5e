"""Local searches from designs that are far from each other, as many as are worth it, and how far they agree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.design.optimize.order import Scores
from tmmcalc.design.optimize.polish import Aim, Locals, polish
from tmmcalc.design.optimize.problem import Problem

Values = NDArray[np.floating[Any]]

LEAST, MOST = 8, 256  # of local searches
WAVE = 16  # of these at most that are begun together
APART = 0.1  # of the box: how far from each other designs in two hollows are
AGREED = 4  # searches, if they are half of all, that end as good as the best: it needs no more of them
EQUAL = 1e-6  # of the objective: two searches that found the same


def free(problem: Problem, objective: int) -> Aim:
    """One objective, whatever the others are."""
    return Aim(objective, np.full(len(problem.objectives), np.inf))


def apart(places: Values, most: int) -> Values:
    """Of designs (n, k), the best first, those that are far from all before."""
    chosen: list[Values] = []
    while len(places) and len(chosen) < most:
        chosen.append(places[0])
        places = places[np.abs(places - places[0]).max(axis=1) > APART]
    return np.array(chosen).reshape(len(chosen), places.shape[1])


def searched(
    problem: Problem, starts: Values, aims: Sequence[Aim], longest: int, budget: int, least: int = 1
) -> Locals:
    """Where local searches end from the first of designs (n, k), as many as ``budget`` designs are enough for.

    They are begun together, ``least`` of them or more; none are where half of those before agree on the best.
    """
    last, most = problem.solved + budget, longest * len(problem.variables)
    ends = Locals(starts[:0], Scores(np.empty((0, len(problem.objectives))), np.empty(0)))
    while (done := len(ends.places)) < len(starts):
        if done and (problem.solved >= last or _agreed(problem, ends, aims)):
            break
        some = slice(done, done + int(np.clip((last - problem.solved) // most, least, WAVE)))
        more = polish(problem, starts[some], aims[some], longest)
        ends = Locals(np.concatenate((ends.places, more.places)), ends.scores.with_more(more.scores))
    return ends


def hits(problem: Problem, ends: Locals, aims: Sequence[Aim]) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """Of each objective the best that searches with their aims have found, inf for nothing, and how many found it."""
    best, found = [], []
    for at in range(len(problem.objectives)):
        own = np.array([aim.objective == at for aim in aims[: len(ends.places)]], bool) & (ends.scores.violation == 0)
        values = ends.scores.objectives[own, at]
        best.append(float(values.min(initial=np.inf)))
        found.append(int((values <= best[-1] + EQUAL * problem.scale(at, best[-1])).sum()) if values.size else 0)
    return tuple(best), tuple(found)


def _agreed(problem: Problem, ends: Locals, aims: Sequence[Aim]) -> bool:
    """Whether of every objective enough searches have ended as good as the best of them."""
    best, found = hits(problem, ends, aims)
    most = len(ends.places) / (2 * len(best))
    return all(count >= max(AGREED, most) for count in found)
