"""What an optimum is like: what binds it and what that costs, how flat it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.differences import slope, steps
from tmmcalc.design.optimize.evolution import evolve, population
from tmmcalc.design.optimize.order import Scores
from tmmcalc.design.optimize.problem import Limit, Problem

Values = NDArray[np.floating[Any]]

SCALE = 1e-2  # of the box, for steps by which kinks are seen
BINDS = 1e-6  # of a limit or of the box: nearer is on it
LEVEL = 0.01  # of the objective: what is worse by no more is as good
REACH = 1e-6  # of the box: the nearest design that is tried for flatness
LADDER = 24  # designs to a side, each farther by the same factor
HALVINGS = 30
STRIDES = 1e-9, 1e-1  # of the box: how far is gone on the way that slopes leave over
ALIKE = 0.1  # of a cost, that two steps may tell it differently
LOOSER = 0.01  # of a limit, by which it is loosened to see what it costs
NEAR = 0.05  # of the box to each side, within which the optimum is sought again
SEEKS = 300  # designs a variable for that


@record
class Binding:
    """A limit that the optimum lies on, of a constraint or of a variable, and what it costs."""

    name: str
    side: str  # "at least" or "at most"
    limit: float
    unit: str
    cost: float  # change of the objective for a change of the limit, in the units of both; NaN: not known
    variable: bool
    again: bool = False  # the cost is what was won when the optimum was sought again with a looser limit, no slope


@record
class Flatness:
    """Between which values of a variable, the others held, the design stays feasible and within LEVEL of the best."""

    name: str
    value: float
    low: float
    high: float


@record
class Stationarity:
    """What is left of the slopes of the objective beside those of the limits that bind.

    ``gain`` is what going along that wins of the objective, as a part of it; NaN where a slope is none. ``kinks`` are
    the slopes that are none.
    """

    gain: float
    kinks: int


def bindings(problem: Problem, place: Values, slopes: Values) -> tuple[tuple[Binding, ...], Stationarity]:
    """What binds a design (k,) of the unit box: multipliers of its limits.

    ``slopes`` (m, f) are the derivatives of all results there by the variables that take any value, over the unit box;
    NaN where there is none.
    """
    from scipy.optimize import nnls

    results = problem.solve(problem.inside(place[None]))[0]
    objective = problem.objectives[0]
    limited = [*_binding_limits(problem, results)]
    walls = [
        (k, side)
        for k in problem.free
        for side in ("at least", "at most")
        if (place[k] if side == "at least" else 1 - place[k]) <= BINDS
    ]
    gradient = objective.sign * slopes[objective.column]
    columns = [sign * slopes[each.column] for each, _, sign in limited]
    inward = np.eye(len(problem.free))
    columns += [(1.0 if side == "at least" else -1.0) * inward[problem.free.index(k)] for k, side in walls]
    kinks = int(np.isnan(gradient).sum())
    costs = np.full(len(columns), np.nan)
    gain = np.nan
    if np.isfinite(gradient).all() and all(np.isfinite(each).all() for each in columns):
        left = gradient
        if columns and gradient.size:
            matrix = np.array(columns).T
            scales = np.linalg.norm(matrix, axis=0)
            scales[scales == 0] = 1.0
            balance, _ = nnls(matrix / scales, gradient)
            costs = balance / scales
            left = gradient - matrix @ costs
        gain = _gain(
            problem,
            place,
            left,
            [(each.column, sign, cost) for (each, _, sign), cost in zip(limited, costs, strict=False)],
        )
    found = []
    for (limit, side, sign), cost in zip(limited, costs, strict=False):
        value = limit.at_least if side == "at least" else limit.at_most
        assert value is not None
        again = not np.isfinite(cost)
        if again:
            cost = _by_seeking(problem, place, limit, side, sign) if problem.free else np.nan
        change = objective.sign * sign * cost
        found.append(Binding(limit.name, side, value, limit.unit, float(change), False, again))
    for (k, side), cost in zip(walls, costs[len(limited) :], strict=True):
        variable = problem.variables[k]
        value = variable.low if side == "at least" else variable.high
        change = objective.sign * (cost if side == "at least" else -cost) / variable.stretch(value)
        found.append(Binding(variable.name, side, value, variable.unit, float(change), True))
    return tuple(found), Stationarity(gain, kinks)


def _gain(problem: Problem, place: Values, left: Values, limited: Sequence[tuple[int, float, float]]) -> float:
    """What the objective wins on the way that slopes (f,) leave over, as a part of it; NaN where nothing is to go to.

    What is won beyond limits, column, sign and cost each, does not count. 0 of an objective that is nothing.
    """
    size = float(np.linalg.norm(left))
    best = float(problem.scores(place[None]).objectives[0, 0])
    if not size:
        return 0.0
    places = np.tile(place, (LADDER, 1))
    places[:, problem.free] -= np.geomspace(STRIDES[0], STRIDES[1], LADDER)[:, None] * left / size
    here = problem.solve(problem.inside(place[None]))[0]
    results = problem.solve(problem.inside(places))
    there = problem.judged(results).objectives[:, 0]
    for column, sign, cost in limited:
        there = there - cost * np.minimum(0.0, sign * (results[:, column] - here[column]))
    there = there[np.isfinite(there)]
    return max(0.0, best - float(there.min())) / problem.scale(0, best) if there.size else np.nan


def _binding_limits(problem: Problem, results: Values) -> list[tuple[Limit, str, float]]:
    """Limits that results lie on, with the side, and the sign by which what is left of them grows with the result."""
    found = []
    for each in problem.rule.limits:
        value = float(results[each.column])
        for side, limit in (("at least", each.at_least), ("at most", each.at_most)):
            near = BINDS * (abs(limit or 0.0) or 1.0)
            if limit is None or abs(value - limit) > near:
                continue
            beside = np.tile(results, (2, 1))
            beside[:, each.column] = limit - 10 * near, limit + 10 * near
            below, above = problem.rule.margin(beside) >= 0
            if below != above:  # else the rule holds, or fails, by other limits
                found.append((each, side, 1.0 if above else -1.0))
    return found


def _by_seeking(problem: Problem, place: Values, limit: Limit, side: str, sign: float) -> float:
    """What a unit of a limit costs: by seeking the optimum again, about the one there is, with the limit a bit looser.

    Where the objective has a kink no slopes balance, and this is the way that is left. NaN where half of the step tells
    another cost.
    """
    value = limit.at_least if side == "at least" else limit.at_most
    assert value is not None
    own = problem.results[:, limit.column]
    step = LOOSER * (abs(value) or float(np.ptp(own[np.isfinite(own)])) or 1.0)
    low, high = np.maximum(place - NEAR, 0.0), np.minimum(place + NEAR, 1.0)
    middle = np.divide(place - low, high - low, out=np.full(len(place), 0.5), where=high > low)
    held = np.isin(np.arange(len(place)), problem.discrete)

    def scores(places: Values) -> Scores:
        return problem.scores(np.where(held, place, low + places * (high - low)))

    before, rule = float(problem.scores(place[None]).objectives[0, 0]), problem.rule
    costs = []
    for part in (step, step / 2):
        problem.rule = rule.moved(limit.name, side, -sign * part)
        try:
            rng = np.random.default_rng(0)
            first = np.concatenate((middle[None], rng.random((population(len(place), SEEKS) - 1, len(place)))))
            found = evolve(scores, first, SEEKS * len(problem.free), rng)
        finally:
            problem.rule = rule
        costs.append(max(0.0, before - float(found.scores.objectives[0, 0])) / part)
    whole, half = costs
    return half if abs(whole - half) <= ALIKE * max(costs) else np.nan


def kinks(problem: Problem, place: Values) -> tuple[NDArray[np.bool_], tuple[str, ...]]:
    """Which results (m, f) have a kink or a jump by which free variable, within a small step of a design (k,).

    And the variables of which a small step has no solution. An optimum often lies on a kink, as where two maxima are
    equally large, but up to rounding: derivatives are then those of one side, and this is seen by steps alone.
    """
    free, moves = problem.free, steps(SCALE)
    here = problem.solve(problem.inside(place[None]))[0]
    places = np.tile(place, (len(free) * len(moves), 1))
    for at, k in enumerate(free):
        places[at * len(moves) : (at + 1) * len(moves), k] += moves
    there = problem.beyond(places).reshape(len(free), len(moves), len(here))
    broken = [
        [slope(SCALE, value, own[:, m]).side in ("kink", "jump", "none") for own in there]
        for m, value in enumerate(here.tolist())
    ]
    ends = tuple(
        problem.variables[k].name
        for k, own in zip(free, there, strict=True)
        if not np.isfinite(own[:, problem.objectives[0].column]).all()
    )
    return np.array(broken, dtype=bool).reshape(len(here), len(free)), ends


def flatness(problem: Problem, place: Values) -> tuple[Flatness, ...]:
    """How far each variable can go to both sides of a design (k,) of the unit box."""
    best = float(problem.scores(place[None]).objectives[0, 0])
    level = best + LEVEL * problem.scale(0, best)
    sides = [(k, sign) for k in problem.free for sign in (-1.0, 1.0)]
    reach = {**_reach(problem, place, level, sides)}
    found = []
    for k, variable in enumerate(problem.variables):
        ends = (
            [place[k] - reach[k, -1.0], place[k] + reach[k, 1.0]]
            if k in problem.free
            else _listed(problem, place, k, level)
        )
        low, high = problem.inside(np.array([np.where(np.arange(len(place)) == k, end, place) for end in ends]))[:, k]
        value = float(problem.inside(place[None])[0, k])
        found.append(Flatness(variable.name, value, float(low), float(high)))
    return tuple(found)


def _good(problem: Problem, places: Values, level: float) -> NDArray[np.bool_]:
    scores = problem.scores(places)
    return np.asarray((scores.violation == 0) & (scores.objectives[:, 0] <= level))


def _reach(
    problem: Problem, place: Values, level: float, sides: Sequence[tuple[int, float]]
) -> dict[tuple[int, float], float]:
    """How far one can go (parts of the box): to the first design that is no longer good, halved down to it."""
    if not sides:
        return {}
    room = np.array([place[k] if sign < 0 else 1 - place[k] for k, sign in sides])
    ladder = np.minimum(np.geomspace(REACH, 1.0, LADDER)[None], room[:, None])

    def good(distances: Values) -> NDArray[np.bool_]:
        places = np.tile(place, (distances.size, 1))
        for at, (k, sign) in enumerate(sides):
            own = slice(at * distances.shape[1], (at + 1) * distances.shape[1])
            places[own, k] += sign * distances[at]
        return _good(problem, places, level).reshape(distances.shape)

    held = np.logical_and.accumulate(good(ladder), axis=1)
    count = held.sum(axis=1)
    rows = np.arange(len(sides))
    low = np.where(count > 0, ladder[rows, np.maximum(count - 1, 0)], 0.0)
    high = ladder[rows, np.minimum(count, LADDER - 1)]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        held_there = good(middle[:, None])[:, 0]
        low, high = np.where(held_there, middle, low), np.where(held_there, high, middle)
        if np.all(high - low <= 1e-6 * high):
            break
    return {side: float(distance) for side, distance in zip(sides, low, strict=True)}


def _listed(problem: Problem, place: Values, k: int, level: float) -> list[float]:
    """The farthest listed values about a design that are as good, all between them with it."""
    count = len(problem.variables[k].among)
    parts = (np.arange(count) + 0.5) / count
    places = np.tile(place, (count, 1))
    places[:, k] = parts
    good = _good(problem, places, level)
    at = int(place[k] * count)
    low = high = min(at, count - 1)
    while low > 0 and good[low - 1]:
        low -= 1
    while high < count - 1 and good[high + 1]:
        high += 1
    return [float(parts[low]), float(parts[high])]
