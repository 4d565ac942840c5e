"""Curves through the points of a period: straight pieces, monotone cubics, a spline; each with its slope, on panels.

The ends of panels are the points, within a panel every curve is a polynomial: nothing is lost there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Panels, Values, panels
from tmmcalc.core.numerics.spline import FEWEST, periodic_spline

WHERE = "torque diagram"
MARGIN = 4  # nodes of a periodic table repeated at either end, more than its interpolation looks


class Curve(NamedTuple):
    """A periodic function through points, with its derivative against theta."""

    panels: Panels  # of [0, period]
    values: Values  # (K, N)
    slope: Values  # (K, N)


def curve(theta: Values, values: Values, period: float, kind: str, unit: str) -> Curve:
    """The curve of a ``kind`` through values (n,) at ascending ``theta`` (n,) [rad] in [0, period].

    "linear" joins them by straight pieces (two points at one angle are a jump), "pchip" by monotone cubics (scipy's),
    "spline" by the cubic spline; all are periodic over the seam. ``unit`` is that of the values, for messages. Raises
    `UsageError` for points out of order or outside the period, too few of them, or an unknown kind.
    """
    if kind not in KINDS:
        raise UsageError(f"there is no interpolation {kind!r}", where=WHERE, remedy=f"kinds: {', '.join(KINDS)}")
    x, y = _ordered(theta, values, period)
    if kind == "linear":
        return _linear(x, y, period)
    if len(x) > 1 and x[-1] - x[0] > period * (1 - 1e-12):
        x, y = _without_seam(x, y, unit)
    fewest = FEWEST if kind == "spline" else 2
    if len(x) < fewest or np.any(np.diff(x) <= 0):
        name, least = ("cubic spline", "three") if kind == "spline" else ("monotone cubic", "two")
        raise UsageError(
            f"the {name} needs {least} points or more, each at its own angle",
            where=WHERE,
            remedy='join points with jumps by kind="linear"',
        )
    return _SMOOTH[kind](x, y, period)


def _linear(x: Values, y: Values, period: float) -> Curve:
    x, y = _closed(x, y, period)
    on = panels(0.0, period, x)
    at = on.x.ravel()
    # Gauss points keep off the jumps, so the piece of a point is the one that begins at the last node before it
    k = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(x) - 2)
    rise = (y[k + 1] - y[k]) / (x[k + 1] - x[k])
    share = (at - x[k]) / (x[k + 1] - x[k])
    values = y[k] + share * (y[k + 1] - y[k])
    return Curve(on, values.reshape(on.x.shape), rise.reshape(on.x.shape))


def _pchip(x: Values, y: Values, period: float) -> Curve:
    from scipy.interpolate import PchipInterpolator  # late: its import takes longer than most answers

    copies = math.ceil(MARGIN / len(x))
    shifts = np.arange(-copies, copies + 1) * period
    through = PchipInterpolator(np.add.outer(shifts, x).ravel(), np.tile(y, len(shifts)))
    on = panels(0.0, period, x)
    return Curve(on, np.asarray(through(on.x)), np.asarray(through(on.x, 1)))


def _spline(x: Values, y: Values, period: float) -> Curve:
    on = panels(0.0, period, x)
    return Curve(on, *periodic_spline(x, y, period)(on.x))


_SMOOTH: dict[str, Callable[[Values, Values, float], Curve]] = {"pchip": _pchip, "spline": _spline}
KINDS = ("linear", *_SMOOTH)


def _without_seam(x: Values, y: Values, unit: str) -> tuple[Values, Values]:
    if abs(y[-1] - y[0]) > 1e-9 * float(np.max(np.abs(y))):
        raise UsageError(
            f"the table ends with {y[-1]:g} {unit} and begins with {y[0]:g} {unit} at the same position of the shaft",
            where=WHERE,
            remedy='make the two equal, or keep the jump with kind="linear"',
        )
    return x[:-1], y[:-1]


def _ordered(theta: Values, values: Values, period: float) -> tuple[Values, Values]:
    slack = 1e-12 * period
    if not len(theta) or not (np.all(np.isfinite(theta)) and np.all(np.isfinite(values))):
        raise UsageError("a diagram needs finite points", where=WHERE, remedy="give pairs of an angle and its value")
    if np.any(np.diff(theta) < 0) or theta[0] < -slack or theta[-1] > period + slack:
        raise UsageError(
            f"the angles must ascend from 0 to the period {period:.6g} rad; given {theta[0]:g} to {theta[-1]:g}",
            where=WHERE,
            remedy="sort the points, give angles in radians, or set the period",
        )
    return np.clip(theta, 0.0, period), values


def _closed(theta: Values, values: Values, period: float) -> tuple[Values, Values]:
    """The points with both ends of the cycle among them, joined over the seam."""
    gap = theta[0] + period - theta[-1]
    seam = values[-1] + (values[0] - values[-1]) * (period - theta[-1]) / gap if gap else values[0]
    if theta[0] > 0:
        theta, values = np.append(0.0, theta), np.append(seam, values)
    if theta[-1] < period:
        theta, values = np.append(theta, period), np.append(values, seam)
    return theta, values
