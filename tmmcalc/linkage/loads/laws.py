"""Values of the laws of technological loads, as functions of theta or of a displacement."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.loading import Indicator, Polynomial
from tmmcalc.linkage.loads.strokes import Piston
from tmmcalc.linkage.loads.travel import EDGE

Law = Callable[[Real], Real]


def polynomial(law: Polynomial, d: Real) -> Real:
    """sum c_k d^k of the angle d (n,) from the beginning of the load's window."""
    value = np.zeros_like(d)
    for c in reversed(law.coefficients):
        value = value * d + c
    return value


def interpolant(x: tuple[float, ...], values: tuple[float, ...], kind: str, period: float | None = None) -> Law:
    """The law through points: straight lines or a monotone cubic (pchip); periodic if a period is given.

    Where the points span the whole period the first and the last value may differ: a jump. On the jump the value
    before it is taken, but at theta = 0 the value after it. Without a period the end values hold beyond the ends.
    """
    at, y = np.array(x), np.array(values)
    if period is not None and at[-1] - at[0] < period - EDGE:
        at, y = np.append(at, at[0] + period), np.append(y, y[0])
    if kind == "linear":
        law: Law = partial(_linear, at, y)
    else:
        law = _pchip(at, y, period if y[0] == y[-1] else None)
    if period is None:
        return lambda v: law(np.clip(v, at[0], at[-1]))
    return lambda v: law(reduced(v, float(at[0]), period))


def _linear(at: Real, y: Real, v: Real) -> Real:
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


class Pressure(NamedTuple):
    """Pressure in a cylinder over its cycle, from one table a stroke."""

    law: Indicator
    piston: Piston
    first: float  # theta at which the first stroke begins [rad]
    half: float  # angle of the strokes away from the closed end [rad]

    @property
    def period(self) -> float:
        """Angle of the cycle [rad]."""
        return TURN * (len(self.law.strokes) // 2)

    @property
    def edges(self) -> list[float]:
        """theta of the beginnings of all strokes [rad]."""
        return [self.first + TURN * (k // 2) + self.half * (k % 2) for k in range(len(self.law.strokes))]

    def __call__(self, theta: Real, coordinate: Real) -> Real:
        """Pressure less that of the other side [Pa] at theta, the piston standing at ``coordinate`` [m]."""
        along = reduced(theta, self.first, self.period) - self.first
        beginnings = np.array(self.edges) - self.first
        stroke = np.maximum(np.searchsorted(beginnings, along - EDGE) - 1, 0)
        x = np.clip((coordinate - self.piston.low) / (self.piston.high - self.piston.low), 0.0, 1.0)
        nodes = (_ascending(*table) for table in self.law.strokes)
        tables = [_linear(np.array(at), np.array(p), x) for at, p in nodes]
        return np.choose(stroke, tables) - self.law.back


def pressure_of(law: Indicator, piston: Piston) -> Pressure:
    """The pressure law of a piston; its first stroke begins at the first outer dead centre from ``delay`` on."""
    turns = np.ceil((law.delay - piston.outer - EDGE) / TURN)
    return Pressure(law, piston, piston.outer + TURN * max(float(turns), 0.0), (piston.inner - piston.outer) % TURN)


def _ascending(x: tuple[float, ...], p: tuple[float, ...]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    return (x, p) if x[0] < x[-1] else (x[::-1], p[::-1])
