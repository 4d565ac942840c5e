"""Search of a box by differential evolution: whole generations at once, for one objective or several.

Success-history based adaptation of its factors (R. Tanabe, A. Fukunaga, Success-history based parameter adaptation for
differential evolution, IEEE CEC 2013, and Improving the search performance of SHADE using linear population size
reduction, IEEE CEC 2014). Of two designs the better is the one that breaks the constraints less (K. Deb 2000); of two
that keep them, of one objective, the one with less of it, of several the one that dominates, and what none dominates is
thinned by the crowding distance (K. Deb et al., NSGA-II, 2002).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.optimize.order import Scores, better, ranked

Values = NDArray[np.floating[Any]]
Evaluate = Callable[[Values], Scores]  # places (n, k) of the unit box
Told = Callable[[Scores], None]

LARGEST, LEAST = 18, 4  # designs a variable at the beginning, designs at the end
CROWD = 240  # designs at most
MEMORY = 6  # successful factors that are remembered
ELITE = 0.11  # of the population: the best, towards which others move
LOST = 2.6  # times the population: replaced designs that still give directions
SAME = 1e-11  # of its size: objectives that differ by less are one
STILL = 1e-9  # of the box: a population within is one design


@record
class Population:
    """Designs (n, k) in the unit box with their scores, the best first."""

    places: Values
    scores: Scores

    def with_more(self, other: Population) -> Population:
        """Both, the best first."""
        scores = self.scores.with_more(other.scores)
        order = ranked(scores)
        return Population(np.concatenate((self.places, other.places))[order], scores[order])


def evolve(
    evaluate: Evaluate,
    first: Values,
    budget: int,
    rng: np.random.Generator,
    told: Told = lambda scores: None,
) -> Population:
    """Evolve a first population (n, k) until it is one design or ``budget`` designs have been evaluated."""
    places, scores = first, evaluate(first)
    spent, start = len(first), len(first)
    several = scores.objectives.shape[1] > 1
    moves, crossings, turn = np.full(MEMORY, 0.5), np.full(MEMORY, 0.5), 0
    lost: Values = np.empty((0, first.shape[1]))
    while True:
        order = ranked(scores)
        places, scores = places[order], scores[order]
        told(scores)
        size = len(places)
        if spent >= budget or (not several and _settled(places, scores)):
            return Population(places, scores)
        slot = rng.integers(MEMORY, size=size)
        cross = np.clip(rng.normal(crossings[slot], 0.1), 0.0, 1.0)
        move = _moves(moves[slot], rng)
        trials = _trials(places, lost, move, cross, rng)
        found = evaluate(trials)
        spent += size
        won = better(found, scores)
        lost = _kept(np.concatenate((lost, places[won])), int(LOST * size), rng)
        if won.any():
            weights = _weights(scores, found, won)
            moves[turn] = weights @ move[won] ** 2 / (weights @ move[won])
            crossings[turn] = weights @ cross[won]
            turn = (turn + 1) % MEMORY
        if several:
            beaten = better(scores, found)
            both = np.concatenate((places[~won], trials[~beaten]))
            joined = scores[~won].with_more(found[~beaten])
            keep = ranked(joined)[:start]
            places, scores = both[keep], joined[keep]
            continue
        equal = (found.violation == scores.violation) & (found.objectives == scores.objectives).all(axis=1)
        taken = won | equal
        places = np.where(taken[:, None], trials, places)
        scores = scores.where(taken, found)
        size = max(LEAST, round(start + (LEAST - start) * min(1.0, spent / budget)))
        keep = ranked(scores)[:size]
        places, scores = places[keep], scores[keep]


def population(variables: int, budget: int) -> int:
    """Designs of the first population."""
    return int(min(LARGEST * variables, CROWD, max(LEAST + 1, budget // 10)))


def spread(variables: int, count: int, seed: int) -> Values:
    """Designs (count, variables) that fill the unit box evenly: scrambled points of Sobol."""
    from scipy.stats import qmc

    sequence = qmc.Sobol(variables, seed=seed)
    return np.asarray(sequence.random_base2(int(np.ceil(np.log2(max(count, 2)))))[:count])


def _settled(places: Values, scores: Scores) -> bool:
    """Whether all designs are one, or equally good ones."""
    if (scores.violation > 0).any():
        return False
    spread = float(np.ptp(scores.objectives[:, 0]))
    size = float(np.abs(scores.objectives[:, 0]).max())
    return spread <= SAME * size or bool(np.ptp(places, axis=0).max() <= STILL)


def _moves(middle: Values, rng: np.random.Generator) -> Values:
    """Factors of the differences, by Cauchy's distribution: above 0, at most 1."""
    found = middle + 0.1 * rng.standard_cauchy(len(middle))
    while (low := found <= 0).any():
        found[low] = middle[low] + 0.1 * rng.standard_cauchy(int(low.sum()))
    return np.minimum(found, 1.0)


def _trials(places: Values, lost: Values, move: Values, cross: Values, rng: np.random.Generator) -> Values:
    """For every design one that is moved towards one of the best, and by a difference of two others, then crossed."""
    size, count = places.shape
    elite = places[rng.integers(max(2, round(ELITE * size)), size=size)]
    pool = np.concatenate((places, lost))
    own = np.arange(size)
    one = (own + rng.integers(1, size, size=size)) % size
    two = np.asarray(rng.integers(len(pool), size=size))
    while (same := (two == own) | (two == one)).any():
        two[same] = rng.integers(len(pool), size=int(same.sum()))
    moved = places + move[:, None] * (elite - places + places[one] - pool[two])
    # what leaves the box is put half way to its wall
    moved = np.where(moved < 0, places / 2, np.where(moved > 1, (places + 1) / 2, moved))
    take = rng.random((size, count)) < cross[:, None]
    take[own, rng.integers(count, size=size)] = True
    return np.where(take, moved, places)


def _kept(lost: Values, most: int, rng: np.random.Generator) -> Values:
    return lost if len(lost) <= most else lost[np.sort(rng.permutation(len(lost))[:most])]


def _weights(before: Scores, after: Scores, won: NDArray[np.bool_]) -> Values:
    """How much each success counts: by what it gains, in the constraints or in the objective."""
    old, new = before[won], after[won]
    gained = np.zeros(len(old.violation))
    for was, now in ((old.violation, new.violation), (old.objectives[:, 0], new.objectives[:, 0])):
        with np.errstate(invalid="ignore"):
            step = was - now
        step = np.where(np.isfinite(step) & (step > 0) & (gained == 0), step, 0.0)
        total = step.sum()
        gained += step / total if total > 0 else 0.0
    gained = gained if gained.sum() > 0 else np.ones(len(gained))
    return np.asarray(gained / gained.sum())
