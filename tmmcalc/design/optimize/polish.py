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
from tmmcalc.design.optimize.problem import INSIDE, Problem
from tmmcalc.design.optimize.together import Ask, together
from tmmcalc.feasibility.judge import sides

Values = NDArray[np.floating[Any]]

STEP, FINER = 1e-5, 1e-6  # of the box, to both sides; and where longer ones gain nothing any more
PRECISION = 1e-13  # of the objective, at which a search stops
BEND = 1e-4  # of the box: steps by which bends are measured
WIDE = 0.25  # of the box: how far a coordinate reaches at most, in which the objective does not bend
LONGEST, SHORTER = 1000, 240  # designs a variable that a search may ask for: one of the best, one of many
ROUND = 120  # steps of a search, after which it is begun anew where it has come to
AGAIN = 20  # times it is begun anew, while this makes it better
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


def polish(problem: Problem, starts: Values, aims: Sequence[Aim], longest: int = LONGEST) -> Locals:
    """The best that local searches from designs (n, k) of the unit box find, each with its aim.

    Each may ask for ``longest`` designs a variable.
    """
    before = problem.scores(starts)
    if not problem.free:
        return Locals(starts, before)
    searches = [partial(_search, problem, start, aim, longest) for start, aim in zip(starts, aims, strict=True)]
    ends = np.array(together(searches, problem.beyond))
    after = problem.scores(ends)
    taken = np.array(
        [bool(better(_by(after, at, aim), _by(before, at, aim))[0]) for at, aim in enumerate(aims)], dtype=bool
    )
    return Locals(np.where(taken[:, None], ends, starts), before.where(taken, after))


def _by(scores: Scores, at: int, aim: Aim) -> Scores:
    """One design as an aim sees it."""
    objectives = scores.objectives[at]
    held = np.isfinite(aim.caps)
    over = np.maximum(0.0, objectives[held] - aim.caps[held] - 1e-9 * np.abs(aim.caps[held])) if held.any() else []
    return Scores(objectives[None, [aim.objective]], np.array([max(scores.violation[at], *over, 0.0)]))


class _SpentError(Exception):
    """A search has stepped through as many designs as it may."""


def _search(problem: Problem, start: Values, aim: Aim, longest: int, ask: Ask) -> Values:
    """The best that one search sees; it is begun anew while that gains."""
    from scipy.optimize import minimize

    picture = _Picture(problem, start, aim, longest, ask)
    free = problem.free
    with suppress(_SpentError):
        known, idle = picture.value(np.zeros(len(free))), 0
        for _ in range(AGAIN):
            if not np.isfinite(known) or idle == 3:
                break
            # where that gains nothing, by shorter steps, then along the variables as they are
            picture.begin(straight=idle < 2, finer=idle > 0)
            minimize(
                picture.scaled,
                np.zeros(len(free)),
                jac=picture.slope,
                method="SLSQP",
                constraints=[{"type": "ineq", "fun": picture.margins, "jac": picture.margin_slopes}],
                options={"ftol": PRECISION, "maxiter": ROUND},
            )
            gain, known = known - picture.least, picture.least
            idle = idle + 1 if gain <= WORTH * abs(known) else 0
    found = start.copy()
    found[free] = picture.best
    return found


class _Picture:
    """Objective and constraints with their slopes about the last place that was asked for.

    Places are told by coordinates y about one of them, ``origin + ways @ y``, along which the objective bends alike: in
    these a narrow curved valley, as sums of squares have, is a bowl, and the first step of a search that of Newton.
    """

    def __init__(self, problem: Problem, start: Values, aim: Aim, longest: int, ask: Ask) -> None:
        self._problem, self._start, self._aim, self._ask = problem, start, aim, ask
        self._free = problem.free
        self._place = np.full(len(self._free), np.nan)
        self._ways: Values = np.eye(len(self._free))
        self._origin, self._scale, self._step = start[self._free], 1.0, STEP
        self.best, self.least, self._broken, self._left = start[self._free], np.inf, np.inf, longest * len(self._free)

    def value(self, y: Values) -> float:
        """The objective, inf where there is none."""
        self._look(y)
        return float(self._value)

    def begin(self, *, straight: bool, finer: bool) -> None:
        """Go on from the best place; ``straight``: with coordinates along which the objective bends alike there.

        ``finer``: with the slopes of shorter steps from now on.
        """
        self._step = FINER if finer else self._step
        self._origin, self._scale = self.best, abs(self.least) or 1.0
        self._ways = self._straightened() if straight else np.eye(len(self._free))
        self._place = np.full(len(self._free), np.nan)

    def _straightened(self) -> Values:
        """Ways (k, k) to either side of the origin of which each changes the objective by half of itself at its end."""
        count = len(self._free)
        first, second = np.triu_indices(count, 1)
        alone, pairs = BEND * np.eye(count), BEND * (np.eye(count)[first] + np.eye(count)[second])
        values = self._asked(self._origin + np.concatenate((np.zeros((1, count)), alone, -alone, pairs, -pairs)))[:, 0]
        here, (up, down), (along, back) = (
            values[0],
            np.split(values[1 : 2 * count + 1], 2),
            np.split(values[2 * count + 1 :], 2),
        )
        bends = np.diag(up + down - 2 * here)
        bends[first, second] = bends[second, first] = (
            along + back + 2 * here - (up + down)[first] - (up + down)[second]
        ) / 2
        own, ways = np.linalg.eigh(np.nan_to_num(bends) / BEND**2)
        return np.asarray(ways / np.sqrt(np.maximum(np.abs(own) / self._scale, WIDE**-2)))

    def scaled(self, y: Values) -> float:
        value = self.value(y) / self._scale
        return value if np.isfinite(value) else WALL

    def slope(self, y: Values) -> Values:
        self._look(y)
        return self._slopes[:, 0] / self._scale

    def margins(self, y: Values) -> Values:
        """What is left to the walls of the box, and to all limits."""
        self._look(y)
        x = self._origin + self._ways @ y
        return np.concatenate((x, 1 - x, self._margins))

    def margin_slopes(self, y: Values) -> Values:
        self._look(y)
        return np.concatenate((self._ways, -self._ways, self._slopes[:, 1:].T))

    def _asked(self, x: Values) -> Values:
        """Objective and limits (n, 1 + c) at places of the variables that are free, NaN where there is no solution."""
        if self._left <= 0:
            raise _SpentError
        self._left -= len(x)
        places = np.tile(self._start, (len(x), 1))
        places[:, self._free] = x
        results = self._ask(places)
        objective = self._problem.judged(results).objectives[:, self._aim.objective]
        every = np.column_stack((objective, self._margins_of(results)))
        return np.where(np.isfinite(every), every, np.nan)

    def _look(self, y: Values) -> None:
        if np.array_equal(y, self._place):
            return
        count = len(y)
        x, steps = self._origin + self._ways @ y, self._step * np.eye(count)
        every = self._asked(x + np.concatenate((np.zeros((1, count)), steps, -steps)))
        here, up, down = every[0], every[1 : count + 1], every[count + 1 :]
        slopes = (up - down) / (2 * self._step)
        slopes = np.where(np.isnan(slopes), (up - here) / self._step, slopes)
        slopes = np.where(np.isnan(slopes), (here - down) / self._step, slopes)
        self._slopes = self._ways.T @ np.nan_to_num(slopes)
        self._place, self._value = y.copy(), np.inf if np.isnan(here[0]) else here[0]
        self._margins = np.where(np.isnan(here[1:]), -WALL, here[1:])
        broken = max(0.0, -float(self._margins.min(initial=0.0)) - INSIDE)
        if np.isfinite(self._value) and (broken, self._value) < (self._broken, self.least):
            self.best, self.least, self._broken = np.clip(x, 0.0, 1.0), float(self._value), broken

    def _margins_of(self, results: Values) -> Values:
        """What is left (n, c) to each limit, or to the rule as a whole, and to the caps of other objectives."""
        rule, columns = self._problem.rule, []
        if rule.plain:
            for each in rule.limits:
                columns += [left - INSIDE for left in sides(results[:, each.column], each.at_least, each.at_most)]
        else:
            columns.append(rule.margin(results) - INSIDE)
        for number, (objective, cap) in enumerate(zip(self._problem.objectives, self._aim.caps, strict=True)):
            if np.isfinite(cap) and number != self._aim.objective:
                columns.append((cap - objective.sign * results[:, objective.column]) / (abs(cap) or 1.0))
        return np.array(columns).reshape(len(columns), len(results)).T
