"""Smooth plane curves, cut into chords or cubics that keep a stated distance from them.

A chord or cubic is halved as long as the curve between its ends strays too far at any of a few interior points.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError, UsageError
from tmmcalc.core.records import record

Real = NDArray[np.floating[Any]]
Plane = NDArray[np.complexfloating[Any, Any]]

INSIDE = np.array([0.25, 0.5, 0.75])  # parts of an interval where the distance is measured
MARGIN = 0.9  # of the tolerance, for what lies between them
MOST = 1_000_000  # intervals
FIRST = 4  # intervals to begin with


@record
class Curve:
    """A smooth curve (n,) -> (n,) of one parameter from ``start`` to ``end``, which may be the smaller one."""

    point: Callable[[Real], Plane]
    rate: Callable[[Real], Plane]  # derivative by the parameter
    start: float
    end: float


Stray = Callable[[Curve, Real, Real], Real]


def chords(curve: Curve, tolerance: float) -> Plane:
    """Points (n,) of the curve whose chords keep within ``tolerance`` of it; the ends are included.

    Raises `UsageError` for a tolerance that is not positive, `AccuracyError` for one that rounding forbids.
    """
    return curve.point(knots(curve, tolerance))


def knots(curve: Curve, tolerance: float) -> Real:
    """Parameters (n,) of the points of `chords`; raises as it does."""
    return _knots(curve, tolerance, _off_chord)


def cubics(curve: Curve, tolerance: float) -> Plane:
    """Control points (n, 4) of Bezier cubics with the curve's tangents, within ``tolerance`` of it.

    Raises as `chords`.
    """
    ends = _knots(curve, tolerance, _off_cubic)
    return _bezier(curve, ends[:-1], ends[1:])


def _knots(curve: Curve, tolerance: float, stray: Stray) -> Real:
    if not tolerance > 0:
        raise UsageError(
            f"a chord tolerance of {tolerance:g} is not positive",
            where="outline",
            value=tolerance,
            limit=0.0,
            remedy="for example a thousandth of the size",
        )
    found = np.linspace(curve.start, curve.end, FIRST + 1)
    if curve.start == curve.end:
        return found[:1]
    while found.size <= MOST:
        low, high = found[:-1], found[1:]
        wide = np.flatnonzero(stray(curve, low, high) > MARGIN * tolerance)
        if not wide.size:
            return found
        found = np.insert(found, wide + 1, (low + high)[wide] / 2)
    raise AccuracyError(
        "no polyline keeps so close to the curve",
        where="outline",
        value=tolerance,
        remedy="a tolerance of at least 1e-11 of the size",
    )


def _inside(low: Real, high: Real) -> Real:
    """Parameters (k, n) inside the intervals."""
    return low + INSIDE[:, None] * (high - low)


def _off_chord(curve: Curve, low: Real, high: Real) -> Real:
    first, last = curve.point(low), curve.point(high)
    chord = last - first
    length = np.maximum(np.abs(chord), np.finfo(float).tiny)
    offset = np.abs((np.conj(chord / length) * (curve.point(_inside(low, high)) - first)).imag)
    return np.max(offset, axis=0)


def _off_cubic(curve: Curve, low: Real, high: Real) -> Real:
    control = _bezier(curve, low, high)
    part = INSIDE[:, None]
    weights = ((1 - part) ** 3, 3 * part * (1 - part) ** 2, 3 * part**2 * (1 - part), part**3)
    fitted = sum(weight * control[:, i] for i, weight in enumerate(weights))
    return np.max(np.abs(fitted - curve.point(_inside(low, high))), axis=0)


def _bezier(curve: Curve, low: Real, high: Real) -> Plane:
    step = (high - low) / 3
    first, last = curve.point(low), curve.point(high)
    return np.stack([first, first + curve.rate(low) * step, last - curve.rate(high) * step, last], axis=-1)
