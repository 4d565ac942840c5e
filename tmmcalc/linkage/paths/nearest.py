"""The places of a path that are nearest to given points, for many variants of a linkage at once.

Half the squared distance D = |r - w|^2 / 2 of the path r(x) from a point w has the derivatives

    D' = (r - w) . r'        D'' = r' . r' + (r - w) . r''

so that a nearest place is a root of D' with D' rising, found by Newton with the exact transfer functions r', r''. The
samples of a survey bracket all roots: a step over which D' goes from below zero to above it holds one; one in which D'
turns back may hide more, as beside a cusp, and is parted where it turns for as long as its cubic may be zero. Steps
that are farther away than the nearest sample by more than the path between their ends are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.survey import within_turn

Track = Callable[[Real, Indices], Plane]
"""(input coordinates (m,), their variants (m,)) -> r, r', r'' (3, m)."""

LONGER = 1.5  # a path between two samples over the chord of its speed there, at most
STILL = 1e-12  # of the size of the scene: a distance that does not change along the path
EQUAL = 4 * EPS  # of the size of the scene: distances that differ by less are equal
NOISE = 4 * EPS  # of what D' is made of: it is a root
ITERATIONS = 80
PARTINGS = 16  # of a step in which D' turns back, at most
TRUSTED = 1  # partings, after which the cubic of D' tells whether there is a root at all
CELLS = 1 << 16  # samples of distances that are looked at together: they stay in cache


class Path(NamedTuple):
    """The path of a point of V variants, along which the nearest places are sought."""

    track: Track
    x: Real  # (V, m) input coordinates of a survey, ascending
    start: Real  # (V,) position 0
    sense: float  # of the motion, 1 or -1
    closed: bool  # a whole turn: the last sample repeats the first


class Nearest(NamedTuple):
    """Input coordinates (V, n) of the places, and which of them are free: neither an end of the path nor anywhere."""

    x: Real
    free: NDArray[np.bool_]


class _Ends(NamedTuple):
    """D' and D'' at the beginning and at the end of steps (...)."""

    slope: Real
    bend: Real
    slope_after: Real
    bend_after: Real


class _Steps(NamedTuple):
    """Intervals (c,) of the input, each for one wanted point of one variant."""

    variant: Indices
    point: Indices
    low: Real
    high: Real
    ends: _Ends

    def some(self, flags: NDArray[np.bool_]) -> _Steps:
        """Those with a flag."""
        ends = _Ends(*(part[flags] for part in self.ends))
        return _Steps(self.variant[flags], self.point[flags], self.low[flags], self.high[flags], ends)


def _joined(parts: Sequence[_Steps]) -> _Steps:
    return _Steps(
        variant=np.concatenate([part.variant for part in parts]),
        point=np.concatenate([part.point for part in parts]),
        low=np.concatenate([part.low for part in parts]),
        high=np.concatenate([part.high for part in parts]),
        ends=_Ends(*map(np.concatenate, zip(*(part.ends for part in parts), strict=True))),
    )


def nearest(path: Path, wanted: Plane) -> Nearest:
    """The places of a path nearest to points ``wanted`` (V, n); of several at one distance the first of the motion.

    A path that is everywhere at one distance from a point is nearest to it in position 0.
    """
    count, n = wanted.shape
    at_once = max(1, CELLS // (n * path.x.shape[1]))
    parts = [_near(path, wanted, np.arange(k, min(k + at_once, count))) for k in range(0, count, at_once)]
    brackets = _brackets(path, wanted, _joined([part.steps for part in parts]))
    sample, size, still = (np.concatenate(each) for each in zip(*(part[1:] for part in parts), strict=True))
    variant, point, x = brackets.variant, brackets.point, _refined(path, brackets, wanted)
    free = np.ones(x.size, bool)
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
    found = Nearest(sample, np.zeros(wanted.shape, bool))  # a sample where rounding leaves no root
    found.x[variant[order], point[order]] = x[order]
    found.free[variant[order], point[order]] = free[order]
    found.x[still], found.free[still] = np.repeat(path.start[:, None], n, axis=1)[still], False
    return found


class _Near(NamedTuple):
    """What a survey of some variants (v,) leaves."""

    steps: _Steps
    sample: Real  # (v, n) input coordinates of the nearest samples
    size: Real  # (v, n) of the scene: the largest coordinate of the path and that of the point
    still: NDArray[np.bool_]  # (v, n) the path is everywhere at one distance from the point


def _near(path: Path, wanted: Plane, variants: Indices) -> _Near:
    """The steps of the survey that may hold the place nearest of all: over which D' rises through zero or turns back.

    The ends of a step are d_0 and d_1 away and the path between them is s long, so that it is nowhere nearer than
    (d_0 + d_1 - s)/2.
    """
    x, w = path.x[variants], wanted[variants]
    samples = path.track(x.ravel(), np.repeat(variants, x.shape[1])).reshape(3, *x.shape)
    if path.closed:  # the same place twice, which rounding must not part
        samples[..., -1] = samples[..., 0]
    r, speed = samples[0], np.abs(samples[1])
    across, up = (each[0][:, None] - each[1][:, :, None] for each in ((r.real, w.real), (r.imag, w.imag)))
    far = np.sqrt(across**2 + up**2)  # (v, n, m)
    least, most = np.min(far, axis=2), np.max(far, axis=2)
    size = np.max(np.abs(r), axis=1)[:, None] + np.abs(w)
    still = most - least <= STILL * size
    way = LONGER * np.maximum(speed[:, :-1], speed[:, 1:]) * np.diff(x)
    near = far[..., :-1] + far[..., 1:] <= way[:, None] + 2 * least[..., None]
    row, point, k = np.nonzero(near & ~still[..., None])
    states = (samples[:, row, k + end] for end in (0, 1))
    ends = _Ends(*(each for state in states for each in slopes_at(state, w[row, point])))
    steps = _Steps(variants[row], point, x[row, k], x[row, k + 1], ends)
    steps = steps.some(_turns(ends, steps.high - steps.low) | _rises(ends))
    sample = np.take_along_axis(x, np.argmin(far, axis=2), axis=1)
    return _Near(steps, sample, size, still)


def slopes_at(state: Plane, wanted: Plane) -> tuple[Real, Real]:
    """D' and D'' (...) of the states r, r', r'' (3, ...) of a path and points (...)."""
    r, v, a = state
    off = r - wanted
    return off.real * v.real + off.imag * v.imag, v.real**2 + v.imag**2 + off.real * a.real + off.imag * a.imag


def _bernstein(ends: _Ends, wide: Real) -> tuple[Real, Real, Real]:
    """The coefficients a, b, c of the slope of the cubic with the values and slopes of D' at both ends of steps.

    They are those of a polynomial of Bernstein over a step of this width: where they have one sign D' does not turn.
    """
    a, c = wide * ends.bend, wide * ends.bend_after
    return a, 1.5 * (ends.slope_after - ends.slope) - 0.5 * (a + c), c


def _turns(ends: _Ends, wide: Real) -> NDArray[np.bool_]:
    """Steps over which D' turns back."""
    a, b, c = _bernstein(ends, wide)
    up = b > 0
    return np.asarray(((a > 0) != up) | ((c > 0) != up))


def _rises(ends: _Ends) -> NDArray[np.bool_]:
    """Steps over which D' goes from below zero to above it."""
    return np.asarray((ends.slope < 0) & (ends.slope_after >= 0))


def _crosses(ends: _Ends, wide: Real) -> NDArray[np.bool_]:
    """Steps over which D' may be zero: the coefficients of Bernstein of its cubic do not have one sign."""
    thirds = ends.slope + wide * ends.bend / 3, ends.slope_after - wide * ends.bend_after / 3
    every = np.stack((ends.slope, *thirds, ends.slope_after))
    return np.asarray((np.min(every, axis=0) <= 0) & (np.max(every, axis=0) >= 0))


def _brackets(path: Path, wanted: Plane, steps: _Steps) -> _Steps:
    """Of steps those, or their parts, over which D' rises through zero."""
    found = []
    for parting in range(PARTINGS):
        wide = steps.high - steps.low
        turns = _turns(steps.ends, wide)
        found.append(steps.some(~turns & _rises(steps.ends)))
        steps = steps.some(turns & (_crosses(steps.ends, wide) | (parting < TRUSTED)))
        if not steps.low.size:
            break
        steps = _parted(path, wanted, steps)
    found.append(steps.some(_rises(steps.ends)))
    return _joined(found)


def _parted(path: Path, wanted: Plane, steps: _Steps) -> _Steps:
    """The steps in up to three parts each, between the places where D' turns back."""
    wide = steps.high - steps.low
    a, b, c = _bernstein(steps.ends, wide)
    inner = [steps.low + t * wide for t in _roots(a - 2 * b + c, 2 * (b - a), a)]
    w = wanted[steps.variant, steps.point]
    states = [slopes_at(path.track(x, steps.variant), w) for x in inner]
    edges = [steps.low, *inner, steps.high]
    states = [steps.ends[:2], *states, steps.ends[2:]]
    parts = [
        _Steps(steps.variant, steps.point, edges[k], edges[k + 1], _Ends(*states[k], *states[k + 1])) for k in range(3)
    ]
    whole = _joined(parts)
    return whole.some(whole.low < whole.high)


def _roots(p: Real, q: Real, r: Real) -> tuple[Real, Real]:
    """The roots of p t^2 + q t + r between 0 and 1, ascending; 1 in place of one beyond.

    Where there are none it is where the polynomial is nearest to zero, and the middle: the next cubics are those of
    shorter steps.
    """
    below = q * q - 4 * p * r
    with np.errstate(divide="ignore", invalid="ignore"):
        far = -0.5 * (q + np.copysign(np.sqrt(np.maximum(below, 0)), q))  # of one sign: no digits are lost
        both = np.stack((far / p, np.where(below < 0, 0.5, r / far)))
        low, high = np.sort(np.where((both > 0) & (both < 1), both, 1.0), axis=0)
    return low, high


def _refined(path: Path, brackets: _Steps, wanted: Plane) -> Real:
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
