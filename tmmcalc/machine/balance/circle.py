"""The smallest circle around points, and around a closed curve given by its Fourier series.

The circle around points is found by growing a support of two or three of them: the farthest point outside joins, the
smallest circle through it and one or two of the old ones takes over, and the radius grows until nothing is outside. A
curve adds its own farthest places, the exact crests of its distance from the present centre, until none lies outside.
The radius around the points found so far bounds the least possible from below, the farthest place of the
curve bounds it from above: their gap certifies the answer. Newton's method goes from the places found so far to those
that hold the circle; mostly it does so from the first ones, and the gap says whether it did.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.fourier import Series, crests
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.machine.balance.contacts import moved, stationary

FIRST = 32  # points of the curve to begin with
PASSES = 60
ROUNDING = 4e-16
ROOT = 1e-7  # of the size: what the radius alone tells of the centre
CLOSED = 1e-13  # the gap, relative to the size of the curve, that ends the search
ROUNDED = 1e-15  # the gap after Newton's method that ends it before: what is left of the gap is rounding
APART = 1e-6  # [rad]: nearer contacts are one, which the equations of three do not tell
OPEN = 1e-9  # the gap from which on the search has failed
TOUCH = 1e-9  # crests that reach the radius but for this part of it touch the circle
HIGH = 0.9  # crests lower than this part of the highest cannot lie outside


@record
class Circle:
    """The smallest circle around a closed curve."""

    center: complex
    radius: float  # farthest place of the curve from the centre
    contacts: tuple[float, ...]  # parameters of the two or three places that hold the circle, ascending
    gap: float  # the radius is at most this much above the least possible
    error: float  # estimated, of the centre


def smallest_circle(points: Plane) -> tuple[complex, float, list[int]]:
    """Centre, radius and supporting points (their indices) of the smallest circle around points (n,).

    >>> smallest_circle(np.array([-1, 0.5j, 1]))[:2]
    (0j, 1.0)
    """
    support = [int(np.argmax(np.abs(points - points[0])))]
    center, radius = complex(points[support[0]]), 0.0
    slack = ROUNDING * float(np.max(np.abs(points)))
    while True:
        distance = np.abs(points - center)
        farthest = int(np.argmax(distance))
        if distance[farthest] <= radius + slack:
            return center, radius, support
        grown = _grown(points, support, farthest)
        if grown[1] <= radius:
            return center, radius, support
        center, radius, support = grown


def _grown(points: Plane, support: list[int], new: int) -> tuple[complex, float, list[int]]:
    """Smallest circle around the support and a point outside it, which lies on the new circle."""
    every = points[[*support, new]]
    slack = ROUNDING * float(np.max(np.abs(points)))
    found = []
    for size in (1, 2):
        for some in combinations(support, size):
            center = _through(points[[*some, new]])
            radius = float(np.max(np.abs(points[[*some, new]] - center)))
            outside = float(np.max(np.abs(every - center))) - radius
            found.append((max(outside - slack, 0.0), radius, center, [*some, new]))
    # a circle that leaves a point out is none; if rounding leaves one out of each, the least of them counts
    _, radius, center, members = min(found, key=lambda circle: circle[:2])
    return center, radius, members


def _through(points: Plane) -> complex:
    """Centre of the circle on two points as diameter, or through three."""
    a, b = complex(points[0]), complex(points[-1])
    if len(points) == 2:
        return (a + b) / 2
    u, v = complex(points[1]) - a, b - a
    area = u.real * v.imag - u.imag * v.real
    if area == 0:
        return (a + b) / 2
    return a + (abs(u) ** 2 * v - abs(v) ** 2 * u) / (2j * area)


def enclosing_circle(curve: Series, error: float = 0.0) -> Circle:
    """The smallest circle around a closed curve; exact but for rounding and an ``error`` of the curve.

    Raises `AccuracyError` if the gap between the bounds does not close.
    """
    size = max(float(np.max(np.abs(curve.even(_first(curve))))), np.finfo(float).tiny)
    unit = Series(curve.coefficients / size)  # so that nothing depends on the unit of force
    for found in _approached(unit):
        circle = _polished(unit, found, error / size)
        if circle.gap <= ROUNDED or found.gap <= CLOSED:
            break
    if circle.gap > OPEN:
        raise AccuracyError(
            f"the smallest circle around the hodograph is open by {circle.gap:.3g} of its size",
            where="balance, minimax",
            value=circle.gap,
            limit=OPEN,
            remedy="use the counterweight of least mean square",
        )
    return Circle(size * circle.center, size * circle.radius, circle.contacts, size * circle.gap, size * circle.error)


def _first(curve: Series) -> int:
    """Points of the curve to begin with."""
    return max(FIRST, 2 * curve.highest + 1)


def _approached(curve: Series) -> Iterator[Circle]:
    """Circles around a curve of the size one, ever closer to the smallest: points are added where it lies outside."""
    t = np.arange(_first(curve)) * (2 * np.pi / _first(curve))
    points = curve.even(len(t))
    best: Circle | None = None
    for _ in range(PASSES):
        center, inner, support = smallest_circle(points)
        at, outer = crests(curve.plus({0: -center}), HIGH)
        radius = max(float(np.max(outer, initial=0.0)), inner)
        if best is not None and best.radius < radius - ROUNDING:
            center, radius = best.center, best.radius
        best = Circle(center, radius, _contacts(curve, t[support], at, radius), max(radius - inner, 0.0), ROOT)
        yield best
        t = np.concatenate((t[support], at))
        points = curve.at(t)


def _polished(curve: Series, circle: Circle, error: float) -> Circle:
    """The same circle with its centre to rounding, where the radius alone tells it to the root of rounding only."""
    t, center = stationary(curve, np.array(circle.contacts), circle.center)
    _, reached = crests(curve.plus({0: -center}), HIGH)
    radius = float(np.max(reached, initial=0.0))
    if not 0 < radius <= circle.radius + CLOSED or _merged(t):
        off = moved(curve, np.array(circle.contacts), circle.center, error)
        return replace(circle, error=off if len(circle.contacts) < 2 else circle.error + off)
    least = smallest_circle(curve.at(t))[1]
    gap = max(radius - least, 0.0)
    return Circle(center, radius, tuple(sorted(t.tolist())), gap, moved(curve, t, center, error))


def _merged(t: Real) -> bool:
    """Whether two contacts (m,) have run into one."""
    places = np.exp(1j * t)
    return len(t) > 1 and bool(np.min(np.abs(places - np.roll(places, 1))) < APART)


def _contacts(curve: Series, support: Real, at: Real, radius: float) -> tuple[float, ...]:
    """Parameters of the crests that hold the circle; the support found before, if rounding leaves no such crests."""
    if len(at) > 1:
        _, reached, places = smallest_circle(curve.at(at))
        if reached >= radius * (1 - TOUCH):
            support = at[places]
    return tuple(sorted(support.tolist()))
