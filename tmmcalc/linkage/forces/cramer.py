"""Systems of up to three equations, many at once."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.plane import Real


def cramer(matrix: Real, right: Real) -> tuple[Real, Real]:
    """Solve the k x k systems (k, k, n), k <= 3, of right sides (k, n); and the determinants (n,).

    A library call a position would cost ten times these few products.
    """
    k = len(right)
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
