"""Which of two designs is the better, and the order of many."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]


@record
class Scores:
    """What counts of n designs: m objectives (n, m), less is better, inf where there is none; what they break (n,).

    ``violation`` is 0 where all constraints hold, inf where a design has no solution.
    """

    objectives: Values
    violation: Values

    def __getitem__(self, some: Any) -> Scores:
        return Scores(self.objectives[some], self.violation[some])

    def with_more(self, other: Scores) -> Scores:
        """These, then those."""
        return Scores(
            np.concatenate((self.objectives, other.objectives)), np.concatenate((self.violation, other.violation))
        )

    def where(self, some: NDArray[np.bool_], other: Scores) -> Scores:
        """Those of the other where ``some`` (n,) is true."""
        return Scores(
            np.where(some[:, None], other.objectives, self.objectives), np.where(some, other.violation, self.violation)
        )


def better(one: Scores, other: Scores) -> NDArray[np.bool_]:
    """Where a design is better than its counterpart: breaks less, or breaks as little and dominates.

    >>> one = Scores(np.array([[1.0, 2.0], [1.0, 3.0], [9.0, 9.0]]), np.array([0.0, 0.0, 0.0]))
    >>> other = Scores(np.array([[1.0, 3.0], [2.0, 2.0], [1.0, 1.0]]), np.array([0.0, 0.0, 0.1]))
    >>> better(one, other).tolist()
    [True, False, True]
    """
    dominates = (one.objectives <= other.objectives).all(axis=-1) & (one.objectives < other.objectives).any(axis=-1)
    return np.asarray((one.violation < other.violation) | ((one.violation == other.violation) & dominates))


def ranked(scores: Scores) -> NDArray[np.intp]:
    """The order of designs, the best first; of several objectives by fronts, within one the least crowded first."""
    if scores.objectives.shape[1] == 1:
        return np.lexsort((scores.objectives[:, 0], scores.violation))
    fronts = front_numbers(scores)
    crowd = np.zeros(len(fronts))
    for number in range(int(fronts.max()) + 1):
        own = np.flatnonzero(fronts == number)
        crowd[own] = crowding(scores.objectives[own])
    return np.lexsort((-crowd, fronts))


def front_numbers(scores: Scores) -> NDArray[np.intp]:
    """The front (n,) of each design: 0 of those that none is better than, 1 of those that only these are, ..."""
    count = len(scores.violation)
    beats = better(
        Scores(scores.objectives[:, None], scores.violation[:, None]),
        Scores(scores.objectives[None], scores.violation[None]),
    )
    numbers = np.full(count, -1, dtype=np.intp)
    left = beats.sum(axis=0)
    number = 0
    while (numbers < 0).any():
        front = (left == 0) & (numbers < 0)
        numbers[front] = number
        left = left - beats[front].sum(axis=0)
        number += 1
    return numbers


def crowding(objectives: Values) -> Values:
    """How far the neighbours of each design (n,) of a front are apart, as parts of its ranges; inf at its ends."""
    count, several = objectives.shape
    apart = np.zeros(count)
    for column in range(several):
        order = np.argsort(objectives[:, column], kind="stable")
        own = objectives[order, column]
        apart[order[[0, -1]]] = np.inf
        span = own[-1] - own[0] if np.isfinite(own).all() else 0.0
        if count > 2 and span > 0:
            apart[order[1:-1]] += (own[2:] - own[:-2]) / span
    return apart
