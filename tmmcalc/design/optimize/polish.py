"""Local searches from many designs at once: sequential quadratic programming over the variables that take any value.

Gradients are central differences, whose steps are solved together with those of all other searches. At a kink, as the
greatest of several values has one, a search may stop early: it never makes a design worse.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.optimize.order import Scores, better
from tmmcalc.design.optimize.problem import TOLERANCE, Problem
from tmmcalc.design.optimize.together import Ask, together
from tmmcalc.feasibility.judge import sides

Values = NDArray[np.floating[Any]]

STEP = 1e-5  # of the box, to both sides
PRECISION = 1e-13  # of the objective, at which a search stops
LONGEST = 120  # designs that a search steps through
AGAIN = 4  # times it is begun anew where it ended, while this makes it better
WORTH = 1e-9  # of the objective: what is gained that another beginning is worth
WALL = 1e6  # times the objective: where there is no solution


@record
class Aim:
    """One of the objectives, and what the others have to keep: at most ``caps`` (m,), inf where it is free."""

    objective: int
    caps: Values


@record
class Locals:
    """Designs (n, k) in the unit box, where searches from n starts have ended, with their scores."""

    places: Values
    scores: Scores


class _Budget:
    """Solves designs for all searches, and counts what is left of those that they may solve."""

    def __init__(self, problem: Problem, most: float) -> None:
        self._problem, self.left = problem, most

    def solve(self, places: Values) -> Values:
        self.left -= len(places)
        return self._problem.beyond(places)


def polish(problem: Problem, starts: Values, aims: Sequence[Aim], most: float = np.inf) -> Locals:
    """The best that local searches from designs (n, k) of the unit box find, each with its aim.

    They end where they are once all together have solved ``most`` designs.
    """
    before = problem.scores(starts)
    if not problem.free:
        return Locals(starts, before)
    budget = _Budget(problem, most)
    searches = [partial(_search, problem, budget, start, aim) for start, aim in zip(starts, aims, strict=True)]
    ends = np.array(together(searches, budget.solve))
    after = problem.scores(ends)
    taken = np.array(
        [bool(better(_by(after, at, aim), _by(before, at, aim))[0]) for at, aim in enumerate(aims)], dtype=bool
    )
    return Locals(np.where(taken[:, None], ends, starts), before.where(taken, after))


def _by(scores: Scores, at: int, aim: Aim) -> Scores:
    """One design as an aim sees it."""
    objectives = scores.objectives[at]
    over = np.maximum(0.0, objectives - aim.caps - 1e-9 * np.abs(aim.caps))[np.isfinite(aim.caps)]
    return Scores(objectives[None, [aim.objective]], np.array([max(scores.violation[at], *over, 0.0)]))


class _SpentError(Exception):
    """A search has stepped through as many designs as it may."""


def _search(problem: Problem, budget: _Budget, start: Values, aim: Aim, ask: Ask) -> Values:
    """The best that one search sees; it is begun anew while that gains."""
    from scipy.optimize import minimize

    picture = _Picture(problem, budget, start, aim, ask)
    free = problem.free
    with suppress(_SpentError):
        known = picture.value(picture.best)
        gain = np.inf
        for _ in range(AGAIN):
            if not np.isfinite(known) or gain <= WORTH * abs(known):
                break
            here, picture.scale = picture.best, abs(known) or 1.0
            minimize(
                picture.scaled,
                here,
                jac=picture.slope,
                method="SLSQP",
                bounds=[(0.0, 1.0)] * len(free),
                constraints=[{"type": "ineq", "fun": picture.margins, "jac": picture.margin_slopes}]
                if picture.limited
                else [],
                options={"ftol": PRECISION, "maxiter": LONGEST},
            )
            gain, known = known - picture.least, picture.least
    found = start.copy()
    found[free] = picture.best
    return found


class _Picture:
    """Objective and constraints with their slopes about the last place that was asked for."""

    def __init__(self, problem: Problem, budget: _Budget, start: Values, aim: Aim, ask: Ask) -> None:
        self._problem, self._budget, self._start, self._aim, self._ask = problem, budget, start, aim, ask
        self._free = problem.free
        self._place = np.full(len(self._free), np.nan)
        self.scale = 1.0
        self.best, self.least, self._broken, self._looks = start[self._free], np.inf, np.inf, 0
        self.limited = bool(len(self._margins_of(np.zeros((1, len(problem.model.names))))[0]))

    def value(self, x: Values) -> float:
        """The objective, inf where there is none."""
        self._look(x)
        return float(self._value)

    def scaled(self, x: Values) -> float:
        value = self.value(x) / self.scale
        return value if np.isfinite(value) else WALL

    def slope(self, x: Values) -> Values:
        self._look(x)
        return self._slopes[:, 0] / self.scale

    def margins(self, x: Values) -> Values:
        self._look(x)
        return self._margins

    def margin_slopes(self, x: Values) -> Values:
        self._look(x)
        return self._slopes[:, 1:].T

    def _look(self, x: Values) -> None:
        if np.array_equal(x, self._place):
            return
        if self._looks == LONGEST or self._budget.left <= 0:
            raise _SpentError
        self._looks += 1
        count = len(x)
        places = np.tile(self._start, (2 * count + 1, 1))
        places[:, self._free] = x
        places[1 : count + 1, self._free] += STEP * np.eye(count)
        places[count + 1 :, self._free] -= STEP * np.eye(count)
        results = self._ask(places)
        objective = self._problem.judged(results).objectives[:, self._aim.objective]
        every = np.column_stack((objective, self._margins_of(results)))
        every = np.where(np.isfinite(every), every, np.nan)
        here, up, down = every[0], every[1 : count + 1], every[count + 1 :]
        slopes = (up - down) / (2 * STEP)
        slopes = np.where(np.isnan(slopes), (up - here) / STEP, slopes)
        slopes = np.where(np.isnan(slopes), (here - down) / STEP, slopes)
        self._slopes = np.nan_to_num(slopes)
        self._place, self._value = x.copy(), np.inf if np.isnan(here[0]) else here[0]
        self._margins = np.where(np.isnan(here[1:]), -WALL, here[1:])
        broken = max(0.0, -float(self._margins.min(initial=0.0)) - TOLERANCE)
        if np.isfinite(self._value) and (broken, self._value) < (self._broken, self.least):
            self.best, self.least, self._broken = np.clip(x, 0.0, 1.0), float(self._value), broken

    def _margins_of(self, results: Values) -> Values:
        """What is left (n, c) to each limit, or to the rule as a whole, and to the caps of other objectives."""
        rule, columns = self._problem.rule, []
        if rule.plain:
            for each in rule.limits:
                columns += sides(results[:, each.column], each.at_least, each.at_most)
        else:
            columns.append(rule.margin(results))
        for number, (objective, cap) in enumerate(zip(self._problem.objectives, self._aim.caps, strict=True)):
            if np.isfinite(cap) and number != self._aim.objective:
                columns.append((cap - objective.sign * results[:, objective.column]) / (abs(cap) or 1.0))
        return np.array(columns).reshape(len(columns), len(results)).T
