"""Systems of up to three equations, many at once."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.plane import Real


def cramer(matrix: Real, right: Real) -> tuple[Real, Real]:
    """Solve the k x k systems (k, k, n), k <= 3, of right sides (k, n); and the determinants (n,).

    A library call a position would cost ten times these few products.
    """
    k, n = right.shape
    if k == 1:
        return right / matrix[0], matrix[0, 0]
    if k == 2:
        (a, b), (c, d) = matrix
        det = a * d - b * c
        return np.array([d * right[0] - b * right[1], a * right[1] - c * right[0]]) / det, det
    again = np.empty((5, 5, n))  # the matrix over and over, so that minors are slices
    again[:3, :3], again[3:, :3] = matrix, matrix[:2]
    again[:, 3:] = again[:, :2]
    crossed = again[1:4, 1:4] * again[2:, 2:] - again[2:, 1:4] * again[1:4, 2:]
    det = np.add.reduce(matrix[0] * crossed[0])
    return np.add.reduce(right[:, None] * crossed) / det, det
