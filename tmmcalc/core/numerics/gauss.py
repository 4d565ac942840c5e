"""The Gauss-Legendre rule on [0, 1], and the matrices that integrate, differentiate and interpolate on its points."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]

ORDER = 16  # points of a rule


class Rule(NamedTuple):
    """Gauss-Legendre rule of n points on [0, 1] and the matrices that act on values at its points."""

    points: Values  # (n,)
    weights: Values  # (n,)
    primitive: Values  # (n, n) integral from 0 to each point
    slope: Values  # (n, n) derivative at each point
    barycentric: Values  # (n,)
    coefficients: Values  # (n, n) values -> Legendre coefficients
    ends: Values  # (2, n) interpolation at 0 and 1


@cache
def rule(n: int = ORDER) -> Rule:
    """The rule of n points, from the distances of its nodes to the nearer end, which keep all their digits.

    >>> rule(2).points.round(6).tolist()
    [0.211325, 0.788675]
    """
    u = _distances(n)
    near, mirrored = _below_one(u, n), slice(n // 2)  # a node in the middle has no mirror image
    degree = np.arange(n)
    p = np.hstack(((-1.0) ** np.arange(n + 1)[:, None] * near, near[:, mirrored][:, ::-1]))
    half = u * (2 - u) / (n * near[n - 1]) ** 2
    weights = np.concatenate((half, half[mirrored][::-1]))
    coefficients = (2 * degree[:, None] + 1) * p[:n] * weights  # the rule finds orthogonal polynomials orthogonal
    upper = np.vstack((p[1] + 1, (p[2:] - p[: n - 1]) / (2 * degree[1:] + 1)[:, None]))
    gap = _gaps(u, n) + np.eye(n)
    barycentric = 1 / np.prod(2 * gap, axis=1)
    slope = barycentric / barycentric[:, None] / gap
    np.fill_diagonal(slope, 0.0)
    np.fill_diagonal(slope, -slope.sum(axis=1))
    ends = np.vstack(((-1.0) ** degree, np.ones(n))) @ coefficients
    points = np.concatenate((u, (2 - u[mirrored])[::-1])) / 2
    return Rule(points, weights, upper.T @ coefficients / 2, 2 * slope, barycentric, coefficients, ends)


def tail(values: Values) -> Values:
    """Size (...) of the last coefficients of values (..., n) at the points: what they leave out, with a margin."""
    last = np.abs(values @ rule(values.shape[-1]).coefficients[-3:].T)
    return np.maximum(np.maximum(last[..., 0], last[..., 1]), last[..., 2])  # a reduction over three takes twice it


@cache
def wide_rule(n: int) -> tuple[Values, Values]:
    """Points and weights (n,) of the rule in extended precision."""
    t = 2 * rule(n).points.astype(np.longdouble) - 1
    for _ in range(2):
        p = legendre(t, n)
        slope = n * (p[n - 1] - t * p[n]) / ((1 - t) * (1 + t))
        t = t - p[n] / slope
    p = legendre(t, n)
    return (t + 1) / 2, (1 - t) * (1 + t) / (n * p[n - 1]) ** 2


def _distances(n: int) -> Values:
    """1 - t of the roots t of P_n from 0 to 1, (n + 1) // 2 of them, rising."""
    angle = np.pi * (4 * np.arange(1, (n + 1) // 2 + 1) - 1) / (4 * n + 2)
    u = 2 * np.sin(angle / 2) ** 2
    for _ in range(5):
        p = _below_one(u, n)
        slope = n * (p[n - 1] - (1 - u) * p[n]) / (u * (2 - u))
        u = u + p[n] / slope
    if n % 2:
        u[-1] = 1.0
    return u


def _below_one(u: Values, n: int) -> Values:
    """Legendre polynomials of degree 0 to n at 1 - u, (n + 1, m), from their differences, which u gives exactly."""
    p = np.ones((n + 1, len(u)))
    difference = np.zeros(len(u))
    for k in range(n):
        difference = (k * difference - (2 * k + 1) * u * p[k]) / (k + 1)
        p[k + 1] = p[k] + difference
    return p


def _gaps(u: Values, n: int) -> Values:
    """Differences t_i - t_j of the nodes, (n, n)."""
    low, high = u - 1, (1 - u[: n // 2])[::-1]
    lower, upper = u[:, None] - u, (u[: n // 2, None] - u[: n // 2]).T[::-1, ::-1]
    across = high[:, None] - low
    return np.block([[lower, -across.T], [across, upper]])


def legendre(t: Values, n: int) -> Values:
    """Legendre polynomials of degree 0 to n at t, (n + 1, m)."""
    p = np.empty((n + 1, len(t)), t.dtype)
    p[0], p[1] = 1.0, t
    for k in range(1, n):
        p[k + 1] = ((2 * k + 1) * t * p[k] - k * p[k - 1]) / (k + 1)
    return p
