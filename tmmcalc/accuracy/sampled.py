"""Extremes of a function that is known at n positions alone, as a table on paper gives them."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.plane import Real

REACH, LEAST = 1e-3, 1e-7  # [rad] of the places about an extreme; nearer than the least its square is rounding
SECOND = "of order 2 on the whole: how near to the extreme a position happens to stand; of order 1 where it jumps"


def around(place: float, count: int = 100) -> tuple[Real, Real]:
    """Places (m,) that close in on one from both sides, and the sides (m,) from which each is taken.

    The place itself stands twice, for both limits at a jump.

    >>> around(1.0, 2)[1].tolist()
    [1.0, 1.0, 1.0, 1.0, 1.0, -1.0]
    """
    away = np.logspace(np.log10(LEAST), np.log10(REACH), count)
    places = np.concatenate((place - away, place + away, [place, place]))
    return places, np.append(np.ones(2 * count + 1), -1.0)
