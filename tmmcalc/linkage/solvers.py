"""The 2x2 linear system of a dyad's velocities and accelerations, in two ways.

In all five dyads the two unknown rates x, y satisfy one plane vector equation

        c1 x + c2 y = w

with the same columns c1, c2 for velocities and accelerations and only w differing (textbook 1.3.3,
2.8.2). A solver takes the columns once and then right-hand sides.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross

Rates = tuple[Real, Real]
PairSolver = Callable[[Plane], Rates]
Method = Callable[[Plane, Plane], PairSolver]


def closed(c1: Plane, c2: Plane) -> PairSolver:
    """Solve by cross products: each unknown is eliminated by the column of the other (section 7)."""
    determinant = cross(c1, c2)

    def solve(w: Plane) -> Rates:
        return cross(w, c2) / determinant, cross(c1, w) / determinant

    return solve


def projection(c1: Plane, c2: Plane) -> PairSolver:
    """Solve the equations projected on two perpendicular axes, as in textbook (2.50) to (2.57)."""
    c1, c2 = np.broadcast_arrays(c1, c2)
    matrix = np.empty((*c1.shape, 2, 2))
    matrix[..., 0, 0], matrix[..., 0, 1] = c1.real, c2.real
    matrix[..., 1, 0], matrix[..., 1, 1] = c1.imag, c2.imag

    def solve(w: Plane) -> Rates:
        rates = np.linalg.solve(matrix, np.stack((w.real, w.imag), axis=-1)[..., None])[..., 0]
        return rates[..., 0], rates[..., 1]

    return solve
