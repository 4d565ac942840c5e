"""The course of a search: complete where it is small, else evolution, then polish; and a second method beside it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import product
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.design.optimize.evolution import Population, evolve, population
from tmmcalc.design.optimize.order import Scores, better, crowding, front_numbers, ranked
from tmmcalc.design.optimize.polish import LONGEST, SHORTER, Aim, Locals, polish
from tmmcalc.design.optimize.problem import Problem

Values = NDArray[np.floating[Any]]
Tell = Callable[[str, Scores], None]  # what is being done, the best so far first

_NUMBERS = re.compile(r"\d[\d.e+-]*")
STARTS = 8, 256  # of local searches, at least and at most
WAVE = 16  # of these at most that are begun together
BRIEF = 100  # designs a variable that each may ask for at least
DRAWN = 16, 0.25  # random designs: so many for the least number of starts, or this part of what may be solved
EQUAL = 1e-6  # of the objective: two methods that found the same
BLOCK = 4096  # designs of a complete search that are asked for at once
SAME = 1e-4  # of the range of a front: designs that differ by less are one
TINY = 1e-300
APART = 0.1  # of the box: how far from each other designs in two hollows are
AGREED = 4  # searches, if they are half of all, that end as good as the best: it needs no more of them
NEAR = 64  # sets of listed values about the best that are tried


@record
class Second:
    """What a second method found, of each objective by itself."""

    method: str
    best: tuple[float, ...]  # inf where it found nothing
    hits: tuple[int, ...] = ()  # of its local searches that found the best, within EQUAL
    starts: int = 0  # the designs that these began from, for each objective; 0: it is no local search
    drawn: int = 0  # of so many random ones
    better: tuple[bool, ...] = ()  # than the first


@record
class Course:
    """The designs (n, v) that were found, in the values of the variables, the best first, and how."""

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
        _check(problem, found.scores)
        return Course(*_chosen(found, designs), f"all {prod(sizes)} designs", True, None)
    several = len(problem.objectives) > 1
    found = _evolved(problem, nominal, budget, seed, 2 * designs if several else 0, tell)
    _refuse_constant(problem)
    tell("polishing", found.scores)
    if several and found.scores.violation.min() == 0:
        best = _polished_front(problem, Population(*_chosen(found, designs)))
    else:
        best = _polished(problem, _of_hollows(problem, found, budget), budget)
    _check(problem, best.scores)
    tell("second method", best.scores)
    second, other = _second(problem, budget, seed)
    joined = _joined(best, other)
    kept = Population(*_chosen(joined, designs))
    mine = best.scores.objectives.min(axis=0)
    ahead = [
        theirs < own - EQUAL * problem.scale(at, own)
        for at, (own, theirs) in enumerate(zip(mine, second.best, strict=True))
    ]
    method = "differential evolution"
    if problem.free:
        method += ", then sequential quadratic programming"
    return Course(kept.places, kept.scores, method, False, replace(second, better=tuple(map(bool, ahead))))


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
    first = _spread(len(problem.variables), max(least, population(len(problem.variables), budget)), seed)
    first[0] = np.clip(problem.parts(nominal), 0.0, 1.0)
    rng = np.random.default_rng(seed)
    return evolve(problem.scores, first, budget, rng, lambda scores: tell("evolution", scores))


def _spread(variables: int, count: int, seed: int) -> Values:
    from scipy.stats import qmc

    sequence = qmc.Sobol(variables, seed=seed)
    return np.asarray(sequence.random_base2(int(np.ceil(np.log2(max(count, 2)))))[:count])


def _check(problem: Problem, scores: Scores) -> None:
    """Raise where there is nothing to be chosen."""
    _refuse_constant(problem)
    if scores.violation.min() == 0:
        return
    if not np.isfinite(scores.violation.min()):
        reasons = [reason for reason in problem.reasons if reason]
        alike = Counter(_NUMBERS.sub("", each) for each in reasons)
        most, times = alike.most_common(1)[0] if alike else ("", 0)
        common = next((each for each in reasons if _NUMBERS.sub("", each) == most), "a result has no value")
        raise NoSolutionError(
            f"none of {problem.solved} designs has a solution; most often, {times} times: {common}",
            where="optimize.variables",
            value=problem.solved,
            remedy="move the limits of the variables to where the spec as it is has one",
        )
    raise _broken(problem)


def _refuse_constant(problem: Problem) -> None:
    """Raise if all that was solved is equally good."""
    for each in problem.objectives:
        own = problem.results[:, each.column]
        own = own[np.isfinite(own)]
        if own.size < 2 or np.ptp(own) > 0:
            return
    names = " and ".join(each.name for each in problem.objectives)
    raise NoSolutionError(
        f"{names} is the same of all {problem.solved} designs: no variable changes it",
        where="optimize",
        remedy="name another result, or other variables",
    )


def _broken(problem: Problem) -> NoSolutionError:
    """What stands in the way where no design keeps the constraints."""
    scores = problem.judged(problem.results)
    order = int(np.argmin(scores.violation))
    nearest = problem.results[order]
    told = []
    for each in problem.rule.limits:
        kept = problem.rule.kept(each, problem.results)
        value = float(nearest[each.column])
        limits = [f"at least {each.at_least:.7g}"] if each.at_least is not None else []
        limits += [f"at most {each.at_most:.7g}"] if each.at_most is not None else []
        told.append(
            f"{each.name} is {value:.7g} {each.unit}".rstrip() + f" ({' and '.join(limits)}; "
            f"{int(kept.sum())} of {len(kept)} designs keep it)"
        )
    return NoSolutionError(
        f"none of {problem.solved} designs keeps the constraints; of the nearest " + ", ".join(told),
        where="constraints",
        value=float(scores.violation[order]),
        limit=0.0,
        remedy="loosen what few keep, or widen the limits of the variables",
    )


def _of_hollows(problem: Problem, found: Population, budget: int) -> Population:
    """The best of local searches from the best designs that are far from each other; the best of evolution with them.

    What evolution leaves is in one hollow; another one may be deeper, and how good a design is tells little of how deep
    its hollow goes. So each search goes on to its end, and there are as many as ``budget`` designs are enough for.
    Designs that break constraints are led to keep them.
    """
    scores = problem.judged(problem.results)
    order = ranked(scores)
    places = problem.parts(problem.values[order[np.isfinite(scores.violation[order])]])
    longest, left = _longest(problem, budget), budget
    if found.scores.violation[0] > 0:
        longest, left = SHORTER, STARTS[0] * SHORTER * len(problem.variables)
    starts = _apart(places, STARTS[1])
    ends = _searched(problem, starts, [_free(problem, 0)] * len(starts), longest, left)
    every = _joined(Population(ends.places, ends.scores), Population(found.places[:1], found.scores[:1]))
    return Population(every.places[:1], every.scores[:1])


def _free(problem: Problem, objective: int) -> Aim:
    """One objective, whatever the others are."""
    return Aim(objective, np.full(len(problem.objectives), np.inf))


def _apart(places: Values, most: int) -> Values:
    """Of designs (n, k), the best first, those that are far from all before."""
    chosen: list[Values] = []
    while len(places) and len(chosen) < most:
        chosen.append(places[0])
        places = places[np.abs(places - places[0]).max(axis=1) > APART]
    return np.array(chosen).reshape(len(chosen), places.shape[1])


def _searched(
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


def _agreed(problem: Problem, ends: Locals, aims: Sequence[Aim]) -> bool:
    """Whether of every objective enough searches have ended as good as the best of them."""
    best, hits = _hits(problem, ends, aims)
    most = len(ends.places) / (2 * len(best))
    return all(count >= max(AGREED, most) for count in hits)


def _hits(problem: Problem, ends: Locals, aims: Sequence[Aim]) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """Of each objective the best that searches with their aims have found, inf for nothing, and how many found it."""
    best, hits = [], []
    for at in range(len(problem.objectives)):
        own = np.array([aim.objective == at for aim in aims[: len(ends.places)]], bool) & (ends.scores.violation == 0)
        values = ends.scores.objectives[own, at]
        best.append(float(values.min(initial=np.inf)))
        hits.append(int((values <= best[-1] + EQUAL * problem.scale(at, best[-1])).sum()) if values.size else 0)
    return tuple(best), tuple(hits)


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


def _longest(problem: Problem, budget: int) -> int:
    """Designs a variable that a local search of the best may ask for."""
    return int(np.clip(budget // len(problem.variables), SHORTER, LONGEST))


def _polished(problem: Problem, best: Population, budget: int) -> Population:
    """The best design by local search; listed values are changed to their neighbours while that makes it better."""
    found = polish(problem, best.places[:1], [_free(problem, 0)], _longest(problem, budget))
    here = Population(found.places, found.scores)
    while problem.discrete:
        starts = _neighbours(problem, here.places[0])
        if not len(starts):
            return here
        found = polish(problem, starts, [_free(problem, 0)] * len(starts))
        at = int(ranked(found.scores)[0])
        if not better(found.scores[[at]], here.scores)[0]:
            return here
        here = Population(found.places[[at]], found.scores[[at]])
    return here


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


def _polished_front(problem: Problem, front: Population) -> Population:
    """Every design of a front by local search: its ends for their own objective, the others with all but one held."""
    count, several = front.scores.objectives.shape
    ends = {int(np.argmin(front.scores.objectives[:, at])): at for at in range(several)}
    aims = []
    for number in range(count):
        if number in ends:
            aims.append(_free(problem, ends[number]))
        else:
            caps = front.scores.objectives[number].copy()
            caps[0] = np.inf
            aims.append(Aim(0, caps))
    found = polish(problem, front.places, aims)
    return Population(found.places, found.scores)


def _second(problem: Problem, budget: int, seed: int) -> tuple[Second, Population]:
    """Another method with as many designs, on its own random numbers."""
    if problem.discrete:
        return _by_scipy(problem, budget, seed)
    return _by_starts(problem, budget, seed)


def _by_starts(problem: Problem, budget: int, seed: int) -> tuple[Second, Population]:
    """Local searches from the best of many random designs that are far from each other, in turns for each objective."""
    variables, several = len(problem.variables), len(problem.objectives)
    drawn = _spread(variables, max(STARTS[0] * DRAWN[0], int(budget * DRAWN[1])), seed + 1)
    scores = problem.scores(drawn)
    chosen: list[tuple[int, int, Values]] = []
    for at in range(several):
        order = ranked(Scores(scores.objectives[:, [at]], scores.violation))
        own = _apart(drawn[order[np.isfinite(scores.violation[order])]], STARTS[1] // several)
        chosen += [(rank, at, place) for rank, place in enumerate(own)]
    chosen.sort(key=lambda each: each[:2])
    method = "sequential quadratic programming from random designs"
    if not chosen:
        return Second(method, (np.inf,) * several, (0,) * several), Population(drawn[:0], scores[:0])
    aims = [_free(problem, at) for _, at, _ in chosen]
    longest = int(np.clip(budget // (STARTS[0] * variables), BRIEF, LONGEST))
    found = _searched(problem, np.array([place for *_, place in chosen]), aims, longest, budget, STARTS[0])
    best, hits = _hits(problem, found, aims)
    kept = found.scores.violation == 0
    second = Second(method, best, hits, -(-len(found.places) // several), len(drawn))
    return second, Population(found.places[kept], found.scores[kept])


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
            here = _polished(problem, here, budget)
        places.append(here.places[0])
        best.append(float(here.scores.objectives[0, at]) if here.scores.violation[0] == 0 else np.inf)
    stack = np.array(places)
    scores = problem.scores(stack)
    kept = scores.violation == 0
    return Second("scipy's differential evolution", tuple(best)), Population(stack[kept], scores[kept])


def _joined(one: Population, other: Population) -> Population:
    """Both, the best first."""
    scores = one.scores.with_more(other.scores)
    order = ranked(scores)
    return Population(np.concatenate((one.places, other.places))[order], scores[order])
