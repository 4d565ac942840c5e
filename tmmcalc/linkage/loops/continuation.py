"""A branch of a group followed along the input: derivatives foretell the next place, Newton finds it.

A step is taken if Newton hardly corrects what was foretold and the determinant keeps its sign: then no other assembly
is so near, and no singular position was stepped over. Otherwise it is halved. Where no step is left, the branch has
come to its limit, which `limitpositions` finds exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.loops.branch import coordinate, slope
from tmmcalc.linkage.loops.closure import Loops
from tmmcalc.linkage.loops.equations import Equations
from tmmcalc.linkage.loops.limitpositions import turning
from tmmcalc.linkage.results import Branch, Interval, Limit

STEPS = 72  # of a turn, or of the asked range: no step is longer
PLACES = 180  # of a branch, on a turn
NEAR = 0.02  # what Newton may correct of a foretold step [rad, or parts of the group's size]
FAST = 0.25  # change of the unknowns in one step at most
LEAST = 1e-6  # of the longest step: below it the branch is at its end
HERE = 1e-12  # of the longest step: that near to a goal it is reached
SAME = 1e-7  # difference of the unknowns after whole turns that is rounding
FAR = 1e3  # sliding coordinates, in parts of the group's size, that run to infinity
SINGULAR = 1e-7  # regularity: Newton finds a singular assembly to the root of a rounding, where it is not quite zero
TURNS = 12  # after which a branch that has not come back is taken as one without a period
PASSES = 6

TURNING = "its links come to a limit position, from which the input can only turn back (the determinant vanishes)"

At = Callable[[Real], Loops]  # the loops of the group at input coordinates (n,)


class BranchPoint(NamedTuple):
    """A place on the branch: coordinate, unknowns (N,) with their derivatives, determinant."""

    x: float
    q: Real
    q1: Real
    q2: Real
    determinant: float


class Continued(NamedTuple):
    """What following in one direction found: places, where and why it ends, its period if it comes back."""

    places: list[BranchPoint]
    limit: float | None = None
    reason: str = ""
    period: float | None = None

    @property
    def end(self) -> float:
        """The farthest coordinate."""
        return self.places[-1].x if self.limit is None else self.limit


def follow(name: str, at: At, x: float, q: Real, interval: Interval, turn: float | None) -> Branch:
    """The branch of a group through the assembly q (N,) at x, as far as it goes in the interval that is left to it.

    With ``turn`` [rad] the input is a crank, which may go round: the branch may come back after one turn or more.
    Raises `SingularityError` if the assembly is singular where it is chosen.
    """
    start = _place(at, x, q)
    if start is None or at(np.array([x])).place(start.q[:, None]).regularity[0] < SINGULAR:
        raise SingularityError(
            "the assembly chosen there is a singular position, from which the motion can go on in two ways",
            where=f"kinematics, group {name}",
            remedy="give assembly.at, another input coordinate, and a sketch of the mechanism there",
        )
    round_turn = turn if not interval.limits else None
    low, high = (x - TURNS * round_turn, x + TURNS * round_turn) if round_turn else (interval.low, interval.high)
    here, longest = at(np.array([x])), (turn or interval.high - interval.low) / STEPS
    follower = _Follower(at, here.equations, here.size, longest, round_turn)
    ahead = follower.go(start, high)
    bare = Branch(name, x, x, ahead.end, (), turn, ahead.period, q[:, None], q[:, None])
    if ahead.period is not None:
        return _sampled(at, ahead.places, bare)
    behind = follower._replace(turn=None).go(start, low)
    limits = [limit for limit in interval.limits if limit.x in (behind.end, ahead.end)]
    limits += [Limit(way.limit, name, way.reason) for way in (behind, ahead) if way.limit is not None]
    places = [*reversed(behind.places), *ahead.places[1:]]
    return _sampled(at, places, replace(bare, low=behind.end, limits=tuple(limits)))


class _Follower(NamedTuple):
    """A group, what its unknowns (N,) are measured by, its longest step, a whole turn if its crank may go round."""

    at: At
    equations: Equations
    size: Real
    longest: float
    turn: float | None

    def go(self, start: BranchPoint, end: float) -> Continued:
        """Follow the branch towards ``end``; with a turn, until it comes back to where it began."""
        places, sense, turns = [start], math.copysign(1.0, end - start.x), 1
        step = self.longest
        while (end - places[-1].x) * sense > HERE * self.longest:
            now = places[-1]
            goal = start.x + sense * turns * self.turn if self.turn else end
            left = abs(goal - now.x)
            found = self._next(now, sense * min(step, left))
            if found is None:
                step = min(step, left) / 2
                if step < LEAST * self.longest:
                    return Continued(places, turning(self.at, now.x, now.q, now.q1, sense, self.size), TURNING)
                continue
            places.append(found)
            far = self._far(found)
            if far is not None:
                return Continued(places, _pole(found, far), self._running(far))
            step = min(self.longest, 2 * step)
            if self.turn and abs(found.x - goal) < HERE * self.longest:
                if self._same(found.q, start.q):
                    return Continued(places, period=turns * self.turn)
                turns += 1
        return Continued(places)

    def _next(self, now: BranchPoint, h: float) -> BranchPoint | None:
        """The place after a step h, None if it is too long."""
        foretold, size = now.q + h * now.q1 + h * h / 2 * now.q2, self._measure(now.q)
        if np.max(np.abs(foretold - now.q) / size) > FAST:
            return None
        found = _place(self.at, now.x + h, foretold)
        if found is None or found.determinant * now.determinant <= 0:
            return None
        missed = np.abs(found.q - foretold), np.abs(found.q1 - now.q1 - h * now.q2) * abs(h)
        return found if np.max(np.maximum(*missed) / size) <= NEAR else None

    @property
    def _angles(self) -> int:
        """How many of the unknowns are angles."""
        return self.equations.classes.shape[1]

    def _measure(self, q: Real) -> Real:
        """What a change of the unknowns (N,) is measured by: a coordinate that is far out by itself."""
        size = self.size.copy()
        size[self._angles :] = np.maximum(size[self._angles :], np.abs(q[self._angles :]))
        return size

    def _far(self, place: BranchPoint) -> int | None:
        """The unknown that runs to infinity."""
        far = np.flatnonzero(np.abs(place.q[self._angles :]) > FAR * self.size[self._angles :])
        return self._angles + int(far[0]) if far.size else None

    def _running(self, unknown: int) -> str:
        """Why a branch ends where a sliding coordinate runs to infinity."""
        eq = self.equations
        joint = eq.rails[eq.free[unknown - self._angles]].joint
        return f"the slider of joint {joint} runs to infinity along its guide, which turns parallel to what holds it"

    def _same(self, q: Real, other: Real) -> bool:
        """Whether two sets of unknowns are one configuration."""
        gap, angles = (q - other) / self.size, self._angles
        gap[:angles] -= 2 * math.pi * np.rint(gap[:angles] / (2 * math.pi))
        return bool(np.max(np.abs(gap)) < SAME)


def _place(at: At, x: float, q: Real) -> BranchPoint | None:
    """Newton at x from q (N,); None if it does not converge to a regular position."""
    loops = at(np.array([x]))
    placed, done = loops.close(q[:, None], PASSES)
    if not done.all():
        return None
    q1, q2 = loops.rates(placed)
    determinant = float(placed.determinant[0])
    regular = np.isfinite(q1).all() and np.isfinite(q2).all() and np.isfinite(determinant) and determinant != 0
    return BranchPoint(x, placed.q[:, 0], q1[:, 0], q2[:, 0], determinant) if regular else None


def _pole(place: BranchPoint, unknown: int) -> float:
    """The input coordinate where an unknown s becomes infinite: the root of 1/s beyond the place, to second order."""
    s, rate, rate2 = place.q[unknown], place.q1[unknown], place.q2[unknown]
    first = s / rate
    return float(place.x + first + first * first * (2 * rate / s - rate2 / rate) / 2)


def _sampled(at: At, places: list[BranchPoint], branch: Branch) -> Branch:
    """The branch with its unknowns at equal steps of its parameter, closed again from those at the places."""
    turns = math.ceil((branch.high - branch.low) / (2 * math.pi)) if branch.period else 2
    t = np.linspace(0.0, 1.0, PLACES * turns + 1)
    x = np.array([place.x for place in places])
    wanted = np.clip(coordinate(branch, t), x[0], x[-1])  # the last trifle before a limit is left to the cubic
    after = np.clip(np.searchsorted(x, wanted), 1, len(x) - 1)
    near = np.where(wanted - x[after - 1] > x[after] - wanted, after, after - 1)
    q, q1, q2 = (np.array([place[part] for place in places]).T[:, near] for part in (1, 2, 3))
    d = wanted - x[near]
    loops = at(wanted)
    placed, done = loops.close(q + d * q1 + d * d / 2 * q2)
    values = np.where(done, placed.q, q)
    rates, _ = loops.rates(placed)
    inside = done & (slope(branch, t) > 0) & (wanted == coordinate(branch, t))
    return replace(branch, q=values, dq=np.where(inside, rates * slope(branch, t), np.gradient(values, t, axis=1)))
