"""The 2x2 linear system of a dyad's velocities and accelerations, in two ways.

In all five dyads the two unknown rates x, y satisfy one plane vector equation

        c1 x + c2 y = w

with the same columns c1, c2 for velocities and accelerations and only w differing (textbook 1.3.3,
2.8.2). A solver takes the columns once and then right-hand sides. Where the second unknown is a sliding, the
equation is written in axes of its line, and c2 is the number 1.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.plane import Parts, Plane, Real, cross

Rates = tuple[Real, Real]
Column = Plane | Parts
PairSolver = Callable[[Column], Rates]
Method = Callable[[Column, Column | int], PairSolver]


def closed(c1: Column, c2: Column | int) -> PairSolver:
    """Solve by cross products: each unknown is eliminated by the column of the other (section 7)."""
    if isinstance(c2, int):
        return lambda w: _along(c1, w)
    determinant = cross(c1, c2)

    def solve(w: Column) -> Rates:
        return cross(w, c2) / determinant, cross(c1, w) / determinant

    return solve


def _along(c1: Column, w: Column) -> Rates:
    """Solve c1 x + y = w: only x has a part across the line, and y is what is left along it."""
    x = w.imag / c1.imag
    return x, w.real - c1.real * x


def projection(c1: Column, c2: Column | int) -> PairSolver:
    """Solve the equations projected on two perpendicular axes, as in textbook (2.50) to (2.57)."""
    matrix = np.empty((*np.broadcast_shapes(np.shape(c1.imag), np.shape(c2.imag)), 2, 2))
    matrix[..., 0, 0], matrix[..., 0, 1] = c1.real, c2.real
    matrix[..., 1, 0], matrix[..., 1, 1] = c1.imag, c2.imag

    def solve(w: Column) -> Rates:
        rates = np.linalg.solve(matrix, np.stack((w.real, w.imag), axis=-1)[..., None])[..., 0]
        return rates[..., 0], rates[..., 1]

    return solve
