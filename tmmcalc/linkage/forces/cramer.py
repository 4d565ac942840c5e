"""Systems of few equations, many at once."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.systems import solve
from tmmcalc.core.plane import Real


def cramer(matrix: Real, right: Real) -> tuple[Real, Real]:
    """Solve the k x k systems (k, k, n) of right sides (k, n); and the determinants (n,).

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
