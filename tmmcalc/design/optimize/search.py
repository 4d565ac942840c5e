"""The course of a search: complete where it is small, else evolution, then polish; and a second method beside it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import product
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.optimize.evolution import Population, evolve, population, spread
from tmmcalc.design.optimize.order import Scores, crowding, front_numbers, ranked
from tmmcalc.design.optimize.problem import Problem
from tmmcalc.design.optimize.refined import of_hollows, polished, polished_front
from tmmcalc.design.optimize.refusal import check, refuse_constant
from tmmcalc.design.optimize.second import Second, second_method
from tmmcalc.design.optimize.starts import EQUAL

Values = NDArray[np.floating[Any]]
Tell = Callable[[str, Scores], None]  # what is being done, the best so far first

BLOCK = 4096  # designs of a complete search that are asked for at once
SAME = 1e-4  # of the range of a front: designs that differ by less are one
TINY = 1e-300


@record
class Course:
    """The designs (n, v) of the unit box that were found, the best first, and how."""

    places: Values
    scores: Scores
    method: str
    complete: bool  # all designs were solved
    second: Second | None


def search(problem: Problem, nominal: Values, budget: int, seed: int, designs: int, tell: Tell) -> Course:
    """Search from the spec as it is, ``nominal`` (v,).

    Raises NoSolutionError where no design has a solution, none keeps the constraints, or all are equally good.
    """
    sizes = [len(each.among) for each in problem.variables]
    if not problem.free and prod(sizes) <= budget:
        found = _complete(problem, sizes, tell)
        check(problem, found.scores)
        return Course(*_chosen(found, designs), f"all {prod(sizes)} designs", True, None)
    several = len(problem.objectives) > 1
    found = _evolved(problem, nominal, budget, seed, 2 * designs if several else 0, tell)
    refuse_constant(problem)
    tell("polishing", found.scores)
    if several and found.scores.violation.min() == 0:
        best = polished_front(problem, Population(*_chosen(found, designs)))
    else:
        best = polished(problem, of_hollows(problem, found, budget), budget)
    check(problem, best.scores)
    tell("second method", best.scores)
    second, other = second_method(problem, budget, seed)
    joined = best.with_more(other)
    kept = Population(*_chosen(joined, designs))
    mine = best.scores.objectives.min(axis=0)
    equal = np.array([EQUAL * problem.scale(at, own) for at, own in enumerate(mine)])
    theirs = np.array(second.best)
    ahead, behind = theirs < mine - equal, theirs > mine + equal
    method = "differential evolution"
    if problem.free:
        method += ", then sequential quadratic programming"
    return Course(
        kept.places,
        kept.scores,
        method,
        False,
        replace(second, better=tuple(ahead.tolist()), worse=tuple(behind.tolist())),
    )


def _complete(problem: Problem, sizes: Sequence[int], tell: Tell) -> Population:
    places: list[Values] = []
    scores: Scores | None = None
    for block in _blocks(sizes):
        found = problem.scores(block)
        places.append(block)
        scores = found if scores is None else scores.with_more(found)
        tell("all designs", scores[ranked(scores)[:1]])
    assert scores is not None
    order = ranked(scores)
    return Population(np.concatenate(places)[order], scores[order])


def _blocks(sizes: Sequence[int]) -> Iterator[Values]:
    block = []
    for own in product(*(range(size) for size in sizes)):
        block.append(own)
        if len(block) == BLOCK:
            yield (np.array(block) + 0.5) / np.array(sizes)
            block = []
    if block:
        yield (np.array(block) + 0.5) / np.array(sizes)


def _evolved(problem: Problem, nominal: Values, budget: int, seed: int, least: int, tell: Tell) -> Population:
    """By evolution from designs, ``least`` of them, that are spread evenly, the spec as it is among them."""
    first = spread(len(problem.variables), max(least, population(len(problem.variables), budget)), seed)
    first[0] = np.clip(problem.parts(nominal), 0.0, 1.0)
    rng = np.random.default_rng(seed)
    return evolve(problem.scores, first, budget, rng, lambda scores: tell("evolution", scores))


def _chosen(found: Population, designs: int) -> tuple[Values, Scores]:
    """Of one objective the best; of several the front, thinned where it is crowded, in the order of the first."""
    if found.scores.objectives.shape[1] == 1:
        return found.places[:1], found.scores[:1]
    own = np.flatnonzero((front_numbers(found.scores) == 0) & (found.scores.violation == 0))
    own = _different(found.scores.objectives, own)
    while len(own) > designs:
        apart = crowding(found.scores.objectives[own])
        own = np.delete(own, int(np.argmin(apart)))
    own = own[np.lexsort(found.scores.objectives[own].T[::-1])]
    return found.places[own], found.scores[own]


def _different(objectives: Values, own: NDArray[np.intp]) -> NDArray[np.intp]:
    """Those designs of a front that are not the same as one before, within a part of the range of all."""
    if not len(own):
        return own
    cells = np.round((objectives[own] - objectives[own].min(axis=0)) / (SAME * np.ptp(objectives[own], axis=0) + TINY))
    _, once = np.unique(cells, axis=0, return_index=True)
    return own[np.sort(once)]
