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
    """The rule of n points.

    >>> rule(2).points.round(6).tolist()
    [0.211325, 0.788675]
    """
    k = np.arange(1, n)
    beta = k / np.sqrt(4.0 * k * k - 1)
    t = np.linalg.eigvalsh(np.diag(beta, 1) + np.diag(beta, -1))
    for _ in range(2):  # the eigenvalues carry a few roundings; Newton on P_n removes them
        p = legendre(t, n)
        t = t - p[n] * (t * t - 1) / (n * (t * p[n] - p[n - 1]))
    t = (t - t[::-1]) / 2
    p = legendre(t, n)
    degree = np.arange(n)
    # near the ends 1 - t^2 has lost digits, so weights from the closed formulas would be good to 1e-14 only
    coefficients = np.linalg.inv(p[:n].T)
    weights = coefficients[0] + coefficients[0, ::-1]
    upper = np.vstack((p[1] + 1, (p[2 : n + 1] - p[: n - 1]) / (2 * degree[1:] + 1)[:, None]))
    gap = t[:, None] - t + np.eye(n)
    barycentric = 1 / np.prod(2 * gap, axis=1)
    slope = barycentric / barycentric[:, None] / gap
    np.fill_diagonal(slope, 0.0)
    np.fill_diagonal(slope, -slope.sum(axis=1))
    ends = np.vstack(((-1.0) ** degree, np.ones(n))) @ coefficients
    return Rule((t + 1) / 2, weights / 2, upper.T @ coefficients / 2, 2 * slope, barycentric, coefficients, ends)


def legendre(t: Values, n: int) -> Values:
    """Legendre polynomials of degree 0 to n at t, (n + 1, m)."""
    p = np.empty((n + 1, len(t)))
    p[0], p[1] = 1.0, t
    for k in range(1, n):
        p[k + 1] = ((2 * k + 1) * t * p[k] - k * p[k - 1]) / (k + 1)
    return p
