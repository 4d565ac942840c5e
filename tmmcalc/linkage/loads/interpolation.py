"""Laws through points: straight lines or a monotone cubic, periodic or not."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.loads.travel import EDGE

Law = Callable[[Real], Real]


def interpolant(x: tuple[float, ...], values: tuple[float, ...], kind: str, period: float | None = None) -> Law:
    """The law through points: straight lines or a monotone cubic (pchip); periodic if a period is given.

    Where the points span the whole period the first and the last value may differ: a jump. On the jump the value
    before it is taken, but at theta = 0 the value after it. Without a period the end values hold beyond the ends.
    """
    at, y = np.array(x), np.array(values)
    if period is not None and at[-1] - at[0] < period - EDGE:
        at, y = np.append(at, at[0] + period), np.append(y, y[0])
    if kind == "linear":
        law: Law = partial(straight, at, y)
    else:
        law = _pchip(at, y, period if y[0] == y[-1] else None)
    if period is None:
        return lambda v: law(np.clip(v, at[0], at[-1]))
    return lambda v: law(reduced(v, float(at[0]), period))


def straight(at: Real, y: Real, v: Real) -> Real:
    """Straight lines through the points (at, y) (m,), at v (n,)."""
    return np.interp(np.asarray(v, float), at, y)


def _pchip(at: Real, y: Real, period: float | None) -> Law:
    """Monotone cubic through the points, of a periodic law with the same slope on both sides of the seam."""
    from scipy.interpolate import PchipInterpolator  # only tables that ask for it pay for scipy

    if period is None:
        smooth: Law = PchipInterpolator(at, y)
        return smooth
    k = np.arange(-3, len(at) + 3) % (len(at) - 1)
    turns = np.floor_divide(np.arange(-3, len(at) + 3), len(at) - 1)
    wrapped: Law = PchipInterpolator(at[k] + turns * period, y[k])
    return wrapped


def reduced(theta: Real, first: float, period: float) -> Real:
    """theta in (first, first + period], so that a seam counts as the end; but theta = 0 is a beginning."""
    t = np.mod(theta - first + EDGE, period) - EDGE
    return first + np.where((t < EDGE) & (theta > EDGE), period, np.maximum(t, 0.0))
