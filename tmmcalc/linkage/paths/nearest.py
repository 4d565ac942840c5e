"""The places of a path that are nearest to given points, for many variants of a linkage at once.

Half the squared distance D = |r - w|^2 / 2 of the path r(x) from a point w has the derivatives

    D' = (r - w) . r'        D'' = r' . r' + (r - w) . r''

so that a nearest place is a root of D' with D' rising, found by Newton with the exact transfer functions r', r''. The
samples of a survey bracket all roots: a step over which D' goes from below zero to above it holds one, and one over
which D'' changes its sign may hide two, which the turning point of D' between them parts. Brackets that are farther
away than the nearest sample by more than the path between their ends are left out.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.survey import within_turn

Track = Callable[[Real, Indices], Plane]
"""(input coordinates (m,), their variants (m,)) -> r, r', r'' (3, m)."""

LONGER = 1.5  # a path between two samples over the chord of its speed there, at most
STILL = 1e-12  # of what D' is made of: a distance that does not change along the path
EQUAL = 1e-12  # of the size of the scene: distances that differ by less are equal
NOISE = 4 * EPS  # of what D' is made of: it is a root
ITERATIONS = 80


class Path(NamedTuple):
    """The samples of a path of V variants, along which the nearest places are sought."""

    track: Track
    x: Real  # (V, m) ascending
    samples: Plane  # (3, V, m) r, r', r''
    start: Real  # (V,) position 0
    sense: float  # of the motion, 1 or -1
    closed: bool  # a whole turn: the last sample repeats the first


class Nearest(NamedTuple):
    """Input coordinates (V, n) of the places, and which of them are free: neither an end of the path nor anywhere."""

    x: Real
    free: NDArray[np.bool_]


class _Brackets(NamedTuple):
    """Steps of the survey (c,) each with a nearest place: variant, wanted point, ends of the input."""

    variant: Indices
    point: Indices
    low: Real
    high: Real


def nearest(path: Path, wanted: Plane) -> Nearest:
    """The places of a path nearest to points ``wanted`` (V, n); of several at one distance the first of the motion.

    A path that is everywhere at one distance from a point is nearest to it in position 0.
    """
    count, n = wanted.shape
    slope, bend = _slopes(path.samples, wanted)
    if path.closed:  # the same place twice, which rounding must not part
        slope[..., -1], bend[..., -1] = slope[..., 0], bend[..., 0]
    r, v, _ = path.samples
    size = np.max(np.abs(r), axis=1)[:, None] + np.abs(wanted)  # (V, n)
    still = np.max(np.abs(slope), axis=2) <= STILL * size * np.max(np.abs(v), axis=1)[:, None]
    brackets = _brackets(path, wanted, slope, bend, ~still)
    at = _refined(path, brackets, wanted)
    variant, point, x, free = brackets.variant, brackets.point, at, np.ones(at.size, bool)
    if not path.closed:
        rows, columns = (each.ravel() for each in np.indices((count, n)))
        for end in (0, -1):
            variant, point = np.append(variant, rows), np.append(point, columns)
            x, free = np.append(x, path.x[rows, end]), np.append(free, np.zeros(rows.size, bool))
    far = np.abs(path.track(x, variant)[0] - wanted[variant, point])
    least = np.full(wanted.shape, np.inf)
    np.minimum.at(least, (variant, point), far)
    best = far <= (least + EQUAL * size)[variant, point]
    variant, point, x, free = variant[best], point[best], x[best], free[best]
    along = path.sense * (x - path.start[variant])
    if path.closed:
        x = within_turn(x, path.start[variant], path.sense)
        along = path.sense * (x - path.start[variant])
    order = np.argsort(along)[::-1]  # what is written last stays: the first of the motion
    found = Nearest(np.repeat(path.start[:, None], n, axis=1), np.zeros(wanted.shape, bool))
    found.x[variant[order], point[order]] = x[order]
    found.free[variant[order], point[order]] = free[order]
    found.x[still], found.free[still] = np.repeat(path.start[:, None], n, axis=1)[still], False
    return found


def slopes_at(state: Plane, wanted: Plane) -> tuple[Real, Real]:
    """D' and D'' (...) of the states r, r', r'' (3, ...) of a path and points (...)."""
    r, v, a = state
    off = r - wanted
    return off.real * v.real + off.imag * v.imag, v.real**2 + v.imag**2 + off.real * a.real + off.imag * a.imag


def _slopes(samples: Plane, wanted: Plane) -> tuple[Real, Real]:
    """D' and D'' (V, n, m) at all samples (3, V, m): linear in the point, so that few passes over the arrays do."""
    r, v, a = samples
    x, y = wanted.real[:, :, None], wanted.imag[:, :, None]
    own = r.real * v.real + r.imag * v.imag
    slope = own[:, None] - x * v.real[:, None]
    slope -= y * v.imag[:, None]
    own = v.real**2 + v.imag**2 + r.real * a.real + r.imag * a.imag
    bend = own[:, None] - x * a.real[:, None]
    bend -= y * a.imag[:, None]
    return slope, bend


def _brackets(path: Path, wanted: Plane, slope: Real, bend: Real, asked: NDArray[np.bool_]) -> _Brackets:
    """All steps with a place that may be the nearest one."""
    below, convex = slope < 0, bend > 0
    before, after = below[..., :-1], below[..., 1:]
    rising = before & ~after & asked[..., None]
    # over a step D' turns back towards zero and away from it again: below zero from above, or the other way
    hides = (before == after) & (convex[..., :-1] == before) & (convex[..., 1:] != before) & asked[..., None]
    plain, hidden = _near(path, wanted, np.nonzero(rising), np.nonzero(hides))
    if not hidden.variant.size:
        return plain
    w = wanted[hidden.variant, hidden.point]

    def turn(x: Real, which: Indices) -> Real:
        return slopes_at(path.track(x, hidden.variant[which]), w[which])[1]

    middle = bracketed(turn, hidden.low, hidden.high)
    first = slopes_at(path.track(hidden.low, hidden.variant), w)[0] < 0
    there = slopes_at(path.track(middle, hidden.variant), w)[0] < 0
    parted = first != there
    low, high = np.where(first, hidden.low, middle), np.where(first, middle, hidden.high)
    both = zip(plain, (hidden.variant, hidden.point, low, high), strict=True)
    return _Brackets(*(np.append(one, other[parted]) for one, other in both))


def _near(path: Path, wanted: Plane, *cells: tuple[Indices, ...]) -> list[_Brackets]:
    """Of steps (variants, points, numbers) those that may hold the nearest place of all.

    The ends of a step are d_0 and d_1 away and the path between them is s long, so that it is nowhere nearer than
    (d_0 + d_1 - s)/2, and somewhere as near as the nearer end.
    """
    r, v, _ = path.samples
    best = np.full(wanted.shape, np.inf)
    if not path.closed:
        best = np.min(np.abs(r[:, None, [0, -1]] - wanted[:, :, None]), axis=2)
    least = []
    for variant, point, k in cells:
        w = wanted[variant, point]
        ends = np.abs(r[variant, k] - w), np.abs(r[variant, k + 1] - w)
        speed = np.maximum(np.abs(v[variant, k]), np.abs(v[variant, k + 1]))
        way = LONGER * speed * (path.x[variant, k + 1] - path.x[variant, k])
        np.minimum.at(best, (variant, point), np.minimum(*ends))
        least.append((ends[0] + ends[1] - way) / 2)
    found = []
    for (variant, point, k), lowest in zip(cells, least, strict=True):
        near = lowest <= best[variant, point]
        variant, point, k = variant[near], point[near], k[near]
        found.append(_Brackets(variant, point, path.x[variant, k], path.x[variant, k + 1]))
    return found


def _refined(path: Path, brackets: _Brackets, wanted: Plane) -> Real:
    """The roots (c,) of D' in brackets over which it rises: Newton, halving where a step leaves the bracket or lags."""
    variant, w = brackets.variant, wanted[brackets.variant, brackets.point]
    least = EPS * float(np.max(np.abs(path.x[:, [0, -1]])))
    low, high = brackets.low.copy(), brackets.high.copy()
    x = (low + high) / 2
    last = high - low
    active = np.arange(x.size)
    for _ in range(ITERATIONS):
        if not active.size:
            break
        at = x[active]
        state = path.track(at, variant[active])
        slope, bend = slopes_at(state, w[active])
        below = slope < 0
        low[active] = bottom = np.where(below, at, low[active])
        high[active] = top = np.where(below, high[active], at)
        with np.errstate(divide="ignore", invalid="ignore"):
            newton = at - slope / bend
        good = (bend > 0) & (newton >= bottom) & (newton <= top) & (2 * np.abs(newton - at) <= last[active])
        onward = np.where(good, newton, (bottom + top) / 2)
        last[active] = step = np.abs(onward - at)
        noise = NOISE * np.abs(state[1]) * (np.abs(state[0]) + np.abs(w[active]))
        there = np.abs(slope) <= noise
        x[active] = np.where(there, at, onward)
        active = active[~(there | (step <= least))]
    return x
