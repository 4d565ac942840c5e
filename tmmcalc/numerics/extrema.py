"""Extreme values of smooth functions to nearly full precision, without their derivatives.

A search on values alone locates an extremum only to the square root of the rounding unit. Here the
function is interpolated at Chebyshev points around a first guess and the root of the interpolant's
derivative is taken, which costs four digits, not eight. Many extrema are refined at once.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from tmmcalc.numerics.roots import Indices, Problems, Values, bracketed

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
    interval shrinks around the estimate until the interpolant is resolved. Where no extremum lies within
    the radius the end nearer to it is returned.
    """
    centre, value, reach = np.array(guess, float), np.empty(np.size(guess)), np.array(radius, float)
    active = np.arange(centre.size)
    for _ in range(PASSES):
        if not active.size:
            break
        x, y, resolved = _one_pass(f, centre[active], reach[active], active)
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
    at[rows] = bracketed(lambda s, k: slope(s, rows[k]), t[cell[rows]], t[cell[rows] + 1], absolute=1e-16)
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
    v = sign * values
    before, after = np.roll(v, 1), np.roll(v, -1)
    if not periodic:
        before, after = before.copy(), after.copy()
        before[0] = after[-1] = -np.inf
    return np.flatnonzero((v >= before) & (v > after))


def spread(x: Values, at: Indices, periodic: bool = False) -> Values:
    """Radius around the samples ``x[at]`` that reaches their farther neighbour but not past the range."""
    gap = np.diff(x)
    before, after = gap[np.maximum(at, 1) - 1], gap[np.minimum(at, len(gap) - 1)]
    radius = np.maximum(before, after)
    if periodic:
        return radius
    return np.minimum(radius, np.minimum(x[at] - x[0], x[-1] - x[at]))
