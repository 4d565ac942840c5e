"""Friction of a group in which one pair alone rubs, in closed form.

The size m of the force grows with the part p of the friction from |b| on, b the force without friction:

    m = |b - p c m S|,   (1 - p^2 c^2 S^2) m^2 + 2 p c (b.S) m = |b|^2

Where friction loads the pair further (c b.S < 0) m has a pole at p |c S| = 1; elsewhere the path folds back at
p |c (b x S)| = |b|, beyond which no m fulfils the equation. From p |c S| = 1 on to the fold there is a second one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Real

Flags = NDArray[np.bool_]


def one_pair(base: Real, response: Real, c: Real) -> tuple[Real, Real, Flags]:
    """Friction q = -c m (1, n), the part of it that moves (n,), 1 if all, and whether there is a second solution.

    ``base`` (2, n) is the force without friction, ``response`` (2, n) that to a unit of it, c (n,) the coefficient with
    its sign. Where the pair locks, q is zero.
    """
    own, along = base[0] * base[0] + base[1] * base[1], c * (base[0] * response[0] + base[1] * response[1])
    across = np.abs(c * (base[0] * response[1] - base[1] * response[0]))
    gain = np.abs(c) * np.sqrt(response[0] * response[0] + response[1] * response[1])
    leading = (1 - gain) * (1 + gain)
    root = np.sqrt(np.maximum(own - across * across, 0.0))  # of the discriminant, for 1 - gain^2 < 0 too
    with np.errstate(divide="ignore", invalid="ignore"):  # in the case that is not taken
        end = np.where(own == 0, np.inf, np.where(along < 0, 1 / gain, np.sqrt(own) / across))
        direct = np.where(along < 0, (root - along) / leading, own / (along + root))
    moves = end > 1
    size = np.where(moves & (own > 0), direct, 0.0)
    return -(c * size)[None], np.where(moves, 1.0, end), moves & (leading < 0) & (own > 0)
