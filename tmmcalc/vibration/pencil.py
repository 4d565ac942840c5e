"""Eigenvalues of a symmetric pencil with one positive definite matrix: B y = mu A y, y' A y = 1.

Rows and columns are scaled to a unit diagonal before A is factored, so stiffnesses that differ by many orders of
magnitude (a bending stiffness beside a weight) cost no digits. numpy alone: many pencils are solved in one call.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.panels import Values

RANK = 1e-13  # of the scaled matrix: a smaller least eigenvalue is none


class Pencil(NamedTuple):
    """Eigenvalues ascending and the vectors in the columns, normalised by A."""

    mu: Values  # (..., n)
    y: Values  # (..., n, n)
    error: Values  # (..., n) bound of the error of mu by its residual


def definite_pencil(b: Values, a: Values, what: str) -> Pencil:
    """Eigenvalues and vectors of B y = mu A y for symmetric B (..., n, n) and positive definite A (n, n).

    ``what`` names A in the message. Raises `NoSolutionError` if A is not positive definite.

    >>> definite_pencil(np.diag([8.0, 3.0]), np.diag([2.0, 1.0]), "mass").mu.round(12).tolist()
    [3.0, 4.0]
    """
    scale, factor = scaled_factor(a, what)
    reduced = _reduced(b * scale[:, None] * scale, factor)
    mu, u = np.linalg.eigh(reduced)
    residual = reduced @ u - u * mu[..., None, :]
    y = scale[:, None] * np.linalg.solve(factor.T, u)
    return Pencil(mu, y, np.linalg.norm(residual, axis=-2))


def scaled_factor(a: Values, what: str) -> tuple[Values, Values]:
    """The scale (n,) that makes the diagonal of A one, and the Cholesky factor of the scaled matrix.

    Raises `NoSolutionError` if A is not positive definite.
    """
    diagonal = np.diagonal(a)
    if np.min(diagonal) <= 0:
        _refuse(what, float(np.min(diagonal)), "diagonal element")
    scale = 1 / np.sqrt(diagonal)
    scaled = a * scale[:, None] * scale
    least = float(np.linalg.eigvalsh(scaled)[0])
    if least < RANK:
        _refuse(what, least, "eigenvalue, of the matrix scaled to a unit diagonal,")
    return scale, np.linalg.cholesky(scaled)


def _reduced(b: Values, factor: Values) -> Values:
    half = np.linalg.solve(factor, b)
    whole = np.linalg.solve(factor, np.swapaxes(half, -1, -2))
    found: Values = (whole + np.swapaxes(whole, -1, -2)) / 2
    return found


def _refuse(what: str, least: float, of: str) -> None:
    raise NoSolutionError(
        f"its least {of} is {least:.6g}: some motion costs no energy, or releases it",
        where=what,
        value=least,
        limit=0.0,
        remedy="look for a mass or stiffness that is missing, or a weight that tips over",
    )
