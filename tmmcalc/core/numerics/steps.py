"""The two Runge-Kutta steps of the course: Kutta-Merson with its error estimate, and the classical step.

States and derivatives are tuples or lists of floats: for the few unknowns of a drive they are faster than arrays.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

State = Sequence[float]
Derivative = Callable[[float, State], State]


class Tableau(NamedTuple):
    """An explicit Runge-Kutta method: k_i = f(t + c_i h, y + h sum a_ij k_j), y+ = y + h sum b_i k_i."""

    nodes: tuple[float, ...]  # c
    rows: tuple[tuple[float, ...], ...]  # a
    weights: tuple[float, ...]  # b
    error: tuple[float, ...]  # of the estimate h sum e_i k_i


# R = h |2 k0 - 9 k2 + 8 k3 - k4| / 30; exact to fifth order for linear equations with constant coefficients
MERSON = Tableau(
    nodes=(0, 1 / 3, 1 / 3, 1 / 2, 1),
    rows=((), (1 / 3,), (1 / 6, 1 / 6), (1 / 8, 0, 3 / 8), (1 / 2, 0, -3 / 2, 2)),
    weights=(1 / 6, 0, 0, 2 / 3, 1 / 6),
    error=(1 / 15, 0, -3 / 10, 4 / 15, -1 / 30),
)


def merson_step(
    f: Derivative, t: float, y: State, h: float, k0: State | None = None, integrals: int = 0
) -> tuple[list[float], list[float]]:
    """One Kutta-Merson step of five evaluations: the new state and the signed error estimate of every component.

    ``k0`` is f(t, y) if it is known; the last ``integrals`` components are those that f does not read, so that they
    need no stages. Source: textbook program 2.3; R. H. Merson (1957).

    >>> y, error = merson_step(lambda x, y: [y[0] - 2 * x / y[0]], 0.0, [1.0], 0.2)
    >>> round(y[0], 9), abs(round(error[0], 10))
    (1.183227848, 1.60485e-05)
    """
    c, a, b, e = MERSON
    k0 = f(t, y) if k0 is None else k0
    z = y[:-integrals] if integrals else y
    p = h * a[1][0]
    k1 = f(t + c[1] * h, [u + p * v for u, v in zip(z, k0, strict=False)])
    p, q = h * a[2][0], h * a[2][1]
    k2 = f(t + c[2] * h, [u + p * v + q * w for u, v, w in zip(z, k0, k1, strict=False)])
    p, q = h * a[3][0], h * a[3][2]
    k3 = f(t + c[3] * h, [u + p * v + q * w for u, v, w in zip(z, k0, k2, strict=False)])
    p, q, r = h * a[4][0], h * a[4][2], h * a[4][3]
    k4 = f(t + h, [u + p * v + q * w + r * x for u, v, w, x in zip(z, k0, k2, k3, strict=False)])
    p, q, r = h * b[0], h * b[3], h * b[4]
    new = [u + p * v + q * w + r * x for u, v, w, x in zip(y, k0, k3, k4, strict=True)]
    p, q, r, s = h * e[0], h * e[2], h * e[3], h * e[4]
    return new, [p * u + q * v + r * w + s * x for u, v, w, x in zip(k0, k2, k3, k4, strict=True)]


def rk4_step(
    f: Derivative, t: float, y: State, h: float, k0: State | None = None, integrals: int = 0
) -> tuple[list[float], None]:
    """One classical Runge-Kutta step in the half-step form; it has no error estimate (textbook (3.69), (3.70)).

    >>> y, _ = rk4_step(lambda x, y: [y[0] - 2 * x / y[0]], 0.0, [1.0], 0.2)
    >>> round(y[0], 9)
    1.183229287
    """
    half = h / 2
    z = y[:-integrals] if integrals else y
    k1 = [half * v for v in (f(t, y) if k0 is None else k0)]
    k2 = [half * v for v in f(t + half, [u + v for u, v in zip(z, k1, strict=False)])]
    k3 = [half * v for v in f(t + half, [u + v for u, v in zip(z, k2, strict=False)])]
    k4 = [half * v for v in f(t + h, [u + 2 * v for u, v in zip(z, k3, strict=False)])]
    return [y0 + (p + 2 * (q + r) + s) / 3 for y0, p, q, r, s in zip(y, k1, k2, k3, k4, strict=True)], None
