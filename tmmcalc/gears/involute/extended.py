"""The involute function and its inverse in extended precision, to measure what rounding leaves of a pair."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.involute.function import SERIES, inverse_involute

Long = NDArray[np.longdouble]

_TAYLOR = tuple(np.longdouble(top) / np.longdouble(bottom) for top, bottom in SERIES)
_SMALL = 0.12  # [rad] below it the eleven terms of the series are exact, above it the difference loses two digits


def involute_extended(angle: Any) -> Long:
    """inv(a) of longdoubles [rad] of any shape, to 1e-17 of itself."""
    a = np.asarray(angle, np.longdouble)
    if np.all(np.abs(a) >= _SMALL):
        return np.asarray(np.tan(a) - a)
    square, series = np.minimum(a * a, _SMALL**2), np.zeros_like(a)
    for coefficient in reversed(_TAYLOR):
        series = series * square + coefficient
    return np.where(np.abs(a) < _SMALL, a**3 * series, np.tan(a) - a)


def inverse_extended(value: Any) -> Long:
    """The angle [rad] whose involute is ``value`` > 0, any shape: one step of Newton's method from the nearest double.

    >>> bool(abs(involute_extended(inverse_extended(0.3)) - np.longdouble(0.3)) < 1e-18)
    True
    """
    q = np.asarray(value, np.longdouble)
    a = np.asarray(inverse_involute(q.astype(float)), np.longdouble)
    return np.asarray(a - (involute_extended(a) - q) / np.tan(a) ** 2)
