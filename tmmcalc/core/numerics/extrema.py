"""Extreme values of smooth functions to nearly full precision, without their derivatives.

A search on values alone locates an extremum only to the square root of the rounding unit. Here the
function is interpolated at Chebyshev points around a first guess and the root of the interpolant's
derivative is taken, which costs four digits, not eight. Many extrema are refined at once.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.roots import Indices, Problems, Values, bracketed

NODES = 17  # points of the local interpolant
RESOLVED = 1e-12  # last coefficients against the largest: the interpolant is then at rounding level
SHRINK = 5.0
PASSES = 6


@cache
def _chebyshev(n: int) -> tuple[Values, Values, Values, Values]:
    """Points (ascending), barycentric weights, differentiation matrix, and values -> coefficients."""
    k = np.arange(n)
    t = -np.cos(np.pi * k / (n - 1))
    weights = np.where(k % 2, -1.0, 1.0)
    weights[[0, -1]] /= 2
    gap = t[:, None] - t[None, :] + np.eye(n)
    matrix = weights[None, :] / weights[:, None] / gap
    np.fill_diagonal(matrix, 0.0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    halves = np.where((k == 0) | (k == n - 1), 2.0, 1.0)
    to_coefficients = 2 / (n - 1) * np.cos(np.pi * np.outer(k, n - 1 - k) / (n - 1)) / np.outer(halves, halves)
    return t, weights, matrix, to_coefficients


def refine(f: Problems, guess: Values, radius: Values) -> tuple[Values, Values]:
    """Extrema of m functions near ``guess`` (m,), each the only one within its ``radius`` (m,).

    ``f(x, which)`` returns values; the result is the positions and the values there, both (m,). The
    interval shrinks around the estimate until the interpolant is resolved; f is never called outside the
    radius. Where no extremum lies within it the end nearer to one is returned.
    """
    centre, value, reach = np.array(guess, float), np.empty(np.size(guess)), np.array(radius, float)
    least, most = centre - reach, centre + reach
    active = np.arange(centre.size)
    for _ in range(PASSES):
        if not active.size:
            break
        low = np.maximum(centre - reach, least)[active]
        high = np.minimum(centre + reach, most)[active]
        x, y, resolved = _one_pass(f, (low + high) / 2, (high - low) / 2, active)
        centre[active], value[active] = x, y
        active = active[~resolved]
        reach /= SHRINK
    return centre, value


def _one_pass(f: Problems, centre: Values, radius: Values, which: Indices) -> tuple[Values, Values, np.ndarray]:
    t, weights, matrix, to_coefficients = _chebyshev(NODES)
    x = centre[:, None] + radius[:, None] * t
    values = f(x.ravel(), np.repeat(which, NODES)).reshape(x.shape)
    slopes = values @ matrix.T
    change = np.signbit(slopes[:, 1:]) != np.signbit(slopes[:, :-1])
    inside = change.any(axis=1)
    middle = np.abs(t[1:] + t[:-1])
    cell = np.argmin(np.where(change, middle, np.inf), axis=1)

    def slope(at: Values, row: Indices) -> Values:
        return _interpolate(slopes[row], at, t, weights)

    at = np.where(slopes[:, NODES // 2] == 0, 0.0, np.where(np.abs(slopes[:, 0]) < np.abs(slopes[:, -1]), -1.0, 1.0))
    rows = np.flatnonzero(inside)
    low, high = t[cell[rows]], t[cell[rows] + 1]
    below, above = slopes[rows, cell[rows]], slopes[rows, cell[rows] + 1]
    first = low + (high - low) * below / np.where(below == above, 1.0, below - above)
    at[rows] = bracketed(lambda s, k: slope(s, rows[k]), low, high, absolute=1e-16, known=(below, above, first))
    coefficients = np.abs(values @ to_coefficients.T)
    resolved = coefficients[:, -3:].max(axis=1) <= RESOLVED * coefficients.max(axis=1)
    return centre + radius * at, _interpolate(values, at, t, weights), resolved


def _interpolate(values: Values, at: Values, t: Values, weights: Values) -> Values:
    """Barycentric interpolation of each row of ``values`` (m, n) at one point of ``at`` (m,)."""
    gap = at[:, None] - t
    exact = gap == 0
    with np.errstate(divide="ignore", invalid="ignore"):
        part = weights / gap
        result = (part * values).sum(axis=1) / part.sum(axis=1)
    hit = exact.any(axis=1)
    return np.where(hit, values[np.arange(len(at)), exact.argmax(axis=1)], result)


def turning(values: Values, sign: int, periodic: bool) -> Indices:
    """Indices of local maxima (``sign`` +1) or minima (-1) of sampled values (n,); a plateau counts once."""
    return np.flatnonzero(maxima(sign * values, periodic))


def maxima(values: Values, periodic: bool) -> NDArray[np.bool_]:
    """Which samples (..., n) are local maxima; a plateau counts once."""
    if periodic:
        before, after = np.roll(values, 1, axis=-1), np.roll(values, -1, axis=-1)
    else:
        beyond = np.full((*values.shape[:-1], 1), -np.inf)
        before = np.concatenate((beyond, values[..., :-1]), axis=-1)
        after = np.concatenate((values[..., 1:], beyond), axis=-1)
    return np.asarray((values >= before) & (values > after))


def around(x: Values, at: Indices, periodic: bool, row: Indices | int = 0) -> tuple[Values, Values]:
    """Centre and radius (m,) of the interval around each turning sample ``x[at]`` that holds the true extremum.

    It reaches the farther neighbour; on an open range (not ``periodic``) it is the last cell for a sample at
    an end. A periodic ``x`` repeats its first sample, a period later, as its last. Of several ranges (V, n) ``row``
    (m,) tells that of each sample.
    """
    x = np.atleast_2d(x)
    gap, here = np.diff(x), x[row, at]
    if periodic:
        return here, np.maximum(gap[row, at - 1], gap[row, at])
    last = x.shape[1] - 1
    before, after = gap[row, np.maximum(at, 1) - 1], gap[row, np.minimum(at, last - 1)]
    radius = np.minimum(np.maximum(before, after), np.minimum(here - x[row, 0], x[row, last] - here))
    end = (at == 0) | (at == last)
    centre = np.where(at == 0, here + after / 2, np.where(end, here - before / 2, here))
    return centre, np.where(end, before / 2, radius)


def with_turning_points(
    f: Problems, x: Values, values: Values, *, near: float, period: float | None = None, touch: float = 0.0
) -> tuple[Values, Values]:
    """Samples (n,) of a function with those turning points added that may lie beyond zero between two of them.

    A local extremum of the samples is refined if it is nearer to zero than ``near`` or than its neighbours are
    to it; it is left out again if it is within ``touch`` of zero. With a ``period`` the last sample repeats
    the first, and the seam is searched like any other place.
    """
    inner = values if period is None else values[:-1]
    step = np.abs(np.diff(values))
    left = np.append(step[:1] if period is None else step[-1:], step)[: len(inner)]
    right = np.append(step, step[-1:])[: len(inner)]
    bound = np.maximum(near, np.maximum(left, right))
    hidden = np.array(
        [i for sign in (1, -1) for i in turning(inner, sign, period is not None) if 0 <= -sign * inner[i] < bound[i]],
        dtype=np.intp,
    )
    if not hidden.size:
        return x, values
    at, value = refine(f, *around(x, hidden, period is not None))
    if period is not None:
        at = x[0] + np.mod(at - x[0], period)
    keep = np.abs(value) > touch
    x, values = np.concatenate((x, at[keep])), np.concatenate((values, value[keep]))
    order = np.argsort(x, kind="stable")
    return x[order], values[order]
