"""Radau IIA collocation of any order: its points, and the matrices between them and the Gauss points of a panel.

The last point is the end of the panel, so the method is L-stable: what a stiff layer leaves unresolved dies out in
the next panel, where Gauss collocation would carry it round the whole period.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER, legendre, rule
from tmmcalc.core.numerics.panels import Values


class Radau(NamedTuple):
    """Radau IIA scheme of n points on (0, 1]."""

    points: Values  # (n,) ascending, the last is 1
    coefficients: Values  # (n, n) values at the points -> Legendre coefficients
    primitive: Values  # (n, n) integral from 0 to each point, of the polynomial through the values
    to_gauss: Values  # (n, n) interpolation from the points to the Gauss points
    from_gauss: Values  # (n, n) interpolation from the Gauss points to the points
    start: Values  # (n,) extrapolation from the points to 0
    nodal: Values  # (n,) at the Gauss points: the polynomial that is 1 at 0 and zero at all points

    def interpolation(self, t: Values) -> Values:
        """Interpolation (m, n) from the points to ``t`` (m,) in [0, 1]."""
        return legendre(2 * t - 1, len(self.points))[:-1].T @ self.coefficients


@cache
def radau(n: int = ORDER) -> Radau:
    """The scheme of n points; it integrates polynomials of degree 2 n - 2 exactly.

    >>> radau(2).points.round(12).tolist()
    [0.333333333333, 1.0]
    """
    t = _points(n)
    coefficients = np.linalg.inv(legendre(t, n)[:n].T)
    gauss = rule(n)
    at_gauss = legendre(2 * gauss.points - 1, n)
    return Radau(
        (t + 1) / 2,
        coefficients,
        _primitive(t, n) @ coefficients,
        at_gauss[:n].T @ coefficients,
        legendre(t, n)[:n].T @ gauss.coefficients,
        (-1.0) ** np.arange(n) @ coefficients,
        (-1.0) ** n * (at_gauss[n] - at_gauss[n - 1]) / 2,
    )


def _points(n: int) -> Values:
    """Roots of P_n - P_(n-1) on (-1, 1]: eigenvalues of the Jacobi matrix with one eigenvalue set to 1."""
    k = np.arange(1, n)
    beta = k / np.sqrt(4.0 * k * k - 1)
    matrix = np.diag(beta, 1) + np.diag(beta, -1)
    matrix[-1, -1] = n / (2 * n - 1)
    t = np.linalg.eigvalsh(matrix)[:-1]
    for _ in range(2):  # Newton removes the roundings of the eigenvalues
        p = legendre(t, n)
        slope = n * (t * p[n] - p[n - 1]) - (n - 1) * (t * p[n - 1] - p[n - 2])
        t = t - (p[n] - p[n - 1]) * (t * t - 1) / slope
    return np.append(t, 1.0)


def _primitive(t: Values, n: int) -> Values:
    """Integrals (m, n) over [0, (t + 1) / 2] of the Legendre polynomials of degree 0 to n - 1."""
    p = legendre(t, n)
    higher = (p[2:] - p[: n - 1]) / (2 * np.arange(1, n) + 1)[:, None]
    return np.vstack((p[1] + 1, higher)).T / 2
