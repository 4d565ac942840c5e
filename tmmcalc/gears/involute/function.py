"""The involute function inv(a) = tan(a) - a and its inverse, to rounding over the whole range.

Both for arrays, for single numbers, and in extended precision, to measure what rounding leaves of a pair.
"""

from __future__ import annotations

from math import atan, cbrt, inf, nan, pi, tan
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.model import Values

Long = NDArray[np.longdouble]

# tan(a) - a = a^3 (1/3 + 2/15 a^2 + ...): numerators and denominators of the Taylor coefficients of tan
SERIES = (
    (1, 3),
    (2, 15),
    (17, 315),
    (62, 2835),
    (1382, 155925),
    (21844, 6081075),
    (929569, 638512875),
    (6404582, 10854718875),
    (443861162, 1856156927625),
    (18888466084, 194896477400625),
    (113927491862, 2900518163668125),
)
_TAYLOR = tuple(top / bottom for top, bottom in SERIES)
_SMALL = 0.3  # [rad] below it the difference tan(a) - a would lose digits
_LONG_TAYLOR = tuple(np.longdouble(top) / np.longdouble(bottom) for top, bottom in SERIES)
_LONG_SMALL = 0.12  # [rad] below it the eleven terms are exact, above it the difference loses two digits
_STEPS = 6  # of Newton's method: from the start below four are enough everywhere


@overload
def involute(angle: float) -> float: ...
@overload
def involute(angle: Values) -> Values: ...
@overload
def involute(angle: float | Values) -> float | Values: ...
def involute(angle: float | Values) -> float | Values:
    """inv(a) = tan(a) - a for angles [rad] from 0 to below pi/2, any shape; to rounding also where both nearly cancel.

    >>> round(float(involute(np.radians(20.0))), 16)
    0.0149043838673364
    """
    if isinstance(angle, float):  # twenty times as fast, and most calls are of this kind
        return _involute_of_one(angle)
    a = np.asarray(angle, dtype=float)
    square = np.minimum(a * a, _SMALL**2)
    series = np.zeros_like(square)
    for coefficient in reversed(_TAYLOR):
        series = series * square + coefficient
    result: Values = np.where(np.abs(a) < _SMALL, a**3 * series, np.tan(a) - a)
    return result


def _involute_of_one(angle: float) -> float:
    if abs(angle) >= _SMALL:
        return tan(angle) - angle
    square, series = angle * angle, 0.0
    for coefficient in reversed(_TAYLOR):
        series = series * square + coefficient
    return angle**3 * series


@overload
def inverse_involute(value: float) -> float: ...
@overload
def inverse_involute(value: Values) -> Values: ...
@overload
def inverse_involute(value: float | Values) -> float | Values: ...
def inverse_involute(value: float | Values) -> float | Values:
    """The angle [rad] from 0 to pi/2 whose involute is ``value`` (any shape, >= 0); nan for negative values.

    Newton's method from the right of the root, where the convex function makes every step safe (textbook 4.57).

    >>> round(float(np.degrees(inverse_involute(0.0149043838673364))), 12)
    20.0
    """
    if isinstance(value, float):
        return _angle_of_one(value)
    q = np.asarray(value, dtype=float)
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.cbrt(3 * q)
        # small: (3q)^(1/3) lies right of the root; large: tan(a) = q + a < q + pi/2
        a = np.where(q < 1, np.minimum(root, np.arctan(q + pi / 2)), np.arctan(q + pi / 2))
        for _ in range(_STEPS):
            slope = np.tan(a) ** 2
            step = np.where(slope > 0, (involute(a) - q) / slope, 0.0)
            a = a - step
        result: Values = np.where(q > 0, a, np.where(q == 0, 0.0, np.nan))
    return result


def _angle_of_one(value: float) -> float:
    if not 0 < value < inf:
        return 0.0 if value == 0 else nan
    far = atan(value + pi / 2)
    a = min(cbrt(3 * value), far) if value < 1 else far
    for _ in range(_STEPS):
        slope = tan(a) ** 2
        if slope == 0:
            break
        a -= (_involute_of_one(a) - value) / slope
    return a


def involute_extended(angle: Any) -> Long:
    """inv(a) of longdoubles [rad] of any shape, to 1e-17 of itself."""
    a = np.asarray(angle, np.longdouble)
    if np.all(np.abs(a) >= _LONG_SMALL):
        return np.asarray(np.tan(a) - a)
    square, series = np.minimum(a * a, _LONG_SMALL**2), np.zeros_like(a)
    for coefficient in reversed(_LONG_TAYLOR):
        series = series * square + coefficient
    return np.where(np.abs(a) < _LONG_SMALL, a**3 * series, np.tan(a) - a)


def inverse_extended(value: Any) -> Long:
    """The angle [rad] whose involute is ``value`` > 0, any shape: one step of Newton's method from the nearest double.

    >>> bool(abs(involute_extended(inverse_extended(0.3)) - np.longdouble(0.3)) < 1e-18)
    True
    """
    q = np.asarray(value, np.longdouble)
    a = np.asarray(inverse_involute(q.astype(float)), np.longdouble)
    return np.asarray(a - (involute_extended(a) - q) / np.tan(a) ** 2)
