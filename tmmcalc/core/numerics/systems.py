"""Small linear systems, one at each of many positions, in double and in extended precision."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]

REFINEMENTS = 3  # of a solution in extended precision: each brings as many digits as double precision has


def solve(matrix: Values, right: Values) -> Values:
    """Solutions x (k, n) of systems (k, k, n) with right sides (k, n); NaN where one is singular or not finite.

    Beyond double precision a solution is refined by its residual, which is taken in that precision.

    >>> solve(np.array([[[0.0], [2.0]], [[4.0], [1.0]]]), np.array([[2.0], [9.0]])).ravel().tolist()
    [2.0, 1.0]
    """
    systems = np.ascontiguousarray(np.moveaxis(matrix, -1, 0), dtype=float)
    x = _solved(systems, right)
    if right.dtype != np.longdouble and matrix.dtype != np.longdouble:
        return x
    x = x.astype(np.longdouble)
    for _ in range(REFINEMENTS):
        x = x + _solved(systems, right - np.einsum("ijn,jn->in", matrix, x))
    return x


def _solved(systems: Values, right: Values) -> Values:
    """Solutions (k, n) in double precision of systems (n, k, k)."""
    sides = np.asarray(right, dtype=float).T[..., None]
    try:
        return np.linalg.solve(systems, sides)[..., 0].T
    except np.linalg.LinAlgError:
        finite = np.flatnonzero(np.isfinite(systems).all(axis=(1, 2)))  # beyond the numbers there is no determinant
        regular = finite[np.linalg.det(systems[finite]) != 0.0]
        found = np.full(sides.shape[:2], np.nan)
        found[regular] = np.linalg.solve(systems[regular], sides[regular])[..., 0]
        return found.T


def cramer(matrix: Values, right: Values) -> tuple[Values, Values]:
    """Solutions (k, n) of systems (k, k, n) with right sides (k, n) by determinants; and these (n,).

    Up to three equations, as those of dyads are, cost a fraction of a library call.
    """
    k = len(right)
    if k > 3:
        return solve(matrix, right), np.linalg.det(np.moveaxis(matrix, -1, 0))
    if k == 1:
        return right / matrix[0], matrix[0, 0]
    if k == 2:
        (a, b), (c, d) = matrix
        det = a * d - b * c
        return np.array([d * right[0] - b * right[1], a * right[1] - c * right[0]]) / det, det
    (a, b, c), (d, e, f), (g, h, i) = matrix
    p, q, r = right
    first, second, third = e * i - f * h, f * g - d * i, d * h - e * g
    det = a * first + b * second + c * third
    qi, qh, qg = q * i - f * r, q * h - e * r, d * r - q * g
    return np.array([p * first - b * qi + c * qh, a * qi + p * second + c * qg, p * third - b * qg - a * qh]) / det, det
