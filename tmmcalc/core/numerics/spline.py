"""The periodic cubic spline through points: the smooth curve for values that repeat, of fourth order in their steps.

scipy has one, whose import takes longer than most answers; here the slopes follow in one pass over the points.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]
Spline = Callable[[Values], tuple[Values, Values]]  # places (m,) -> values and slopes (m,)

FEWEST = 3  # points of a period


def periodic_spline(x: Values, y: Values, period: float) -> Spline:
    """The spline through values (n,) at ascending ``x`` (n,) of one ``period``, n > 2, with its slope.

    Its slopes m at the points follow from equal curvature on both sides: with steps h and chords d,
    h_k m_(k-1) + 2 (h_(k-1) + h_k) m_k + h_(k-1) m_(k+1) = 3 (h_k d_(k-1) + h_(k-1) d_k).

    >>> at = np.arange(24) * np.pi / 12
    >>> value, slope = periodic_spline(at, np.sin(at), 2 * np.pi)(np.array([0.1]))
    >>> [abs(float(round(v, 3))) for v in (value[0] - np.sin(0.1), slope[0] - np.cos(0.1))]
    [0.0, 0.0]
    """
    knots, ends = np.append(x, x[0] + period), np.append(y, y[0])
    h = np.diff(knots)
    chord = np.diff(ends) / h
    before = np.roll(h, 1)
    slope = _cyclic(h, 2 * (before + h), before, 3 * (h * np.roll(chord, 1) + before * chord))
    later = np.append(slope, slope[0])

    def spline(at: Values) -> tuple[Values, Values]:
        u = np.mod(at - x[0], period) + x[0]
        i = np.clip(np.searchsorted(knots, u, side="right") - 1, 0, len(x) - 1)
        t = (u - knots[i]) / h[i]
        low, high = slope[i] - chord[i], later[i + 1] - chord[i]  # slopes at both ends beyond the chord's
        value = ends[i] + t * (ends[i + 1] - ends[i]) + h[i] * t * (1 - t) * ((1 - t) * low - t * high)
        return value, chord[i] + (1 - t) * (1 - 3 * t) * low - t * (2 - 3 * t) * high

    return spline


def _cyclic(lower: Values, diagonal: Values, upper: Values, right: Values) -> Values:
    """Solution (n,) of a_k m_(k-1) + b_k m_k + c_k m_(k+1) = r_k whose neighbours go round, b larger than a + c.

    Elimination without the two corners, for the right side and for the corners by themselves (Sherman-Morrison).
    """
    corner = -diagonal[0]
    inner = diagonal.copy()
    inner[0] -= corner
    inner[-1] -= lower[0] * upper[-1] / corner
    of_corner = np.zeros(len(right))
    of_corner[0], of_corner[-1] = corner, upper[-1]
    own, turned = _eliminated(lower, inner, upper, np.stack((right, of_corner), axis=1)).T
    share = lower[0] / corner
    return np.asarray(own - turned * (own[0] + share * own[-1]) / (1 + turned[0] + share * turned[-1]))


def _eliminated(lower: Values, diagonal: Values, upper: Values, right: Values) -> Values:
    """Solutions (n, s) without corners; the recurrence has no vectorised form, and plain floats are the fastest."""
    a, b, c = lower.tolist(), diagonal.tolist(), upper.tolist()
    r, s = (column.tolist() for column in right.T)
    for k in range(1, len(b)):
        factor = a[k] / b[k - 1]
        b[k] -= factor * c[k - 1]
        r[k] -= factor * r[k - 1]
        s[k] -= factor * s[k - 1]
    r[-1], s[-1] = r[-1] / b[-1], s[-1] / b[-1]
    for k in range(len(b) - 2, -1, -1):
        r[k] = (r[k] - c[k] * r[k + 1]) / b[k]
        s[k] = (s[k] - c[k] * s[k + 1]) / b[k]
    return np.array([r, s]).T
