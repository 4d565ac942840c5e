"""The border of the places of the cam's axis from which the cam passes the pivot of its rocker.

    |o - u| - |o| <= (r2 - r_A)/l2,     u = e^(i y_max)

in the plane of `halfplanes`: u is the roller centre at its highest. With l2 given the border is a branch of a
hyperbola about A and u, with l0 given the circle |o - u| = k |o|, k = 1 + (r2 - r_A)/l0. The limits of the pressure
angle leave a convex region, and the levels of an aim are convex: where the best place of the region is beyond the
border, the best of those that pass lies on it.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acos, pi

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.synthesis.curves import Curve
from tmmcalc.cams.synthesis.objectives import Objective
from tmmcalc.cams.task import Asked
from tmmcalc.core.numerics.panels import panels, resolved
from tmmcalc.core.records import record

NEAR = 1e-9  # [rad] the ends of a border are not reached


@record
class Passage:
    """What a cam needs to pass the pivot."""

    asked: Asked
    top: complex  # u
    spare: float  # r2 - r_A [m]

    def over(self, points: Complex) -> Values:
        """By how much, in lengths of the rocker, the cam about the axis at ``points`` reaches beyond the pivot."""
        return np.abs(points - self.top) - np.abs(points) - self.spare / self._length(points)

    def _length(self, points: Complex) -> Values:
        """l2 [m] by the length that is given."""
        if self.asked.rocker is not None:
            return np.full(np.shape(points), self.asked.rocker)
        if self.asked.centres is not None:
            return self.asked.centres / np.abs(points)
        return (self.asked.base or 0.0) / np.abs(points - 1)


@record
class Border:
    """The curve on which the cam just passes, and the parameter x of a point of it; deeper with growing x."""

    curve: Curve
    at: Callable[[complex], float]


def border(passage: Passage, aim: Objective) -> Border | None:
    """The border for a given rocker or given centres; None if no place passes, or all do."""
    asked, u = passage.asked, passage.top
    if asked.rocker is not None:
        found = hyperbola(u, passage.spare / asked.rocker)
    else:
        found = _circle(u, 1 + passage.spare / (asked.centres or 1.0))
    if found is None:
        return None
    low, high, points, at = found
    inner = _stationary(points, low, high, aim)
    return Border(Curve("pivot", points, low, high, inner), at)


_Found = tuple[float, float, Callable[[Values], Complex], Callable[[complex], float]]


def hyperbola(u: complex, c: float) -> _Found | None:
    """In polar form about the pivot, x the angle from u down to o: |o| = (1 - c^2)/2/(cos x + c); None if |c| >= 1."""
    if abs(c) >= 1:
        return None

    def points(x: Values) -> Complex:
        return np.asarray((1 - c * c) / 2 / (np.cos(x) + c) * np.exp(-1j * x) * u)

    return 0.0, acos(-c) - NEAR, points, lambda o: -float(np.angle(o / u))


def _circle(u: complex, k: float) -> _Found | None:
    """Of Apollonius."""
    if k <= 0:
        return None

    def points(x: Values) -> Complex:
        return np.asarray(u / (1 + k * np.exp(1j * x)))

    return NEAR, pi - NEAR, points, lambda o: float(np.angle(u / o - 1))


def _stationary(points: Callable[[Values], Complex], low: float, high: float, aim: Objective) -> tuple[float, ...]:
    """Where the aim, brought to a finite range, does not change along the border."""

    def near(x: Values) -> Values:
        return 1 / (1 + aim.of(points(x))[None] ** 2)

    on, values, _ = resolved(near, panels(low, high))
    at, _ = on.turning(values[0])
    return tuple(x for x in at.tolist() if low < x < high)
