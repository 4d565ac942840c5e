"""Periodic functions of an angle as Fourier series: sampled until resolved, with exact means and extremes.

f(t) = sum of c_k exp(i k t) for k from -K to K, complex or real. A smooth periodic function has coefficients that fall
geometrically, so equal steps and the fast transform give them to rounding as soon as the step is fine enough; the
number of samples is doubled until the highest coefficients say that it is. Mean squares are sums over coefficients,
and the extremes of |f| are roots of a derivative that is known exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.roots import Indices, Values, bracketed
from tmmcalc.core.records import record

Complex = NDArray[np.complexfloating[Any, Any]]

TURN = 2 * math.pi
FEWEST = 64  # samples of the first pass
MOST = 2**16
RESOLVED = 1e-13  # root of the squares of the highest coefficients, a quarter of all, against the function's scale
FLOOR = 1e-8  # a tail below it that no longer falls is rounding
NEGLIGIBLE = 1e-16  # coefficients against the scale that are left out at the end of a series
FINENESS = 8  # samples for extremes per order
BLOCK = 2**20  # terms computed at once
SAME = 1e-12  # crests that differ less, relatively, are one height


@record
class Series:
    """A Fourier series by its ``coefficients`` c_k (2 K + 1,), for the orders -K to K."""

    coefficients: Complex

    @property
    def highest(self) -> int:
        """The highest order K."""
        return len(self.coefficients) // 2

    @property
    def orders(self) -> NDArray[np.int_]:
        """The orders -K to K."""
        return np.arange(-self.highest, self.highest + 1)

    @property
    def rms(self) -> float:
        """Root mean square of |f| over a turn."""
        return float(np.linalg.norm(self.coefficients))

    def coefficient(self, order: int) -> complex:
        """c_k, zero beyond the highest order."""
        return complex(self.coefficients[order + self.highest]) if abs(order) <= self.highest else 0j

    def at(self, t: Values) -> Complex:
        """Values (m,) at the angles ``t`` (m,).

        >>> Series(np.array([0.5, 0, 0.5])).at(np.array([0.0, math.pi])).real.tolist()
        [1.0, -1.0]
        """
        return _values(t, self.orders, self.coefficients)

    def even(self, count: int) -> Complex:
        """Values at ``count`` equal steps from 0, more than 2 K of them."""
        spread = np.zeros(count, np.complex128)
        spread[self.orders] = self.coefficients
        return np.fft.ifft(spread) * count

    def slope(self) -> Series:
        """The derivative."""
        return Series(1j * self.orders * self.coefficients)

    def turned(self, order: int) -> Series:
        """The function times exp(i order t)."""
        wide = np.pad(self.coefficients, abs(order))
        return Series(np.roll(wide, order))

    def plus(self, terms: Mapping[int, complex]) -> Series:
        """The function with these coefficients added, by order."""
        beyond = max((abs(k) for k in terms), default=0) - self.highest
        c = np.pad(self.coefficients, max(beyond, 0)).astype(np.complex128)
        for k, value in terms.items():
            c[k + len(c) // 2] += value
        return Series(c)


@record
class Magnitude:
    """How large |f| is over a turn."""

    rms: float  # root mean square over the angle
    largest: float
    at: float  # angle of the largest, from 0 to 2 pi [rad]


def resolved(
    f: Callable[[Values], Complex], scale: Values, *, tolerance: float = RESOLVED, where: str = ""
) -> tuple[tuple[Series, ...], float]:
    """The series of all functions of ``f(t) -> (F, n)``, of one length, and what their highest orders still hold.

    ``scale`` (F,) is the size that rounding in each function is proportional to; the rest is relative to it. Raises
    `AccuracyError` if the functions are not smooth enough for 65536 samples.
    """
    unit = np.where(scale > 0, scale, 1.0)[:, None]
    n, before = FEWEST, math.inf
    while True:
        c = np.fft.fft(f(np.arange(n) * (TURN / n)), axis=-1) / n
        tail = float(np.max(np.linalg.norm(c[:, 3 * n // 8 : 5 * n // 8 + 1] / unit, axis=1)))
        floor = FLOOR > tail > before / 2
        if tail <= tolerance or floor or n >= MOST:
            break
        n, before = 2 * n, tail
    if tail > FLOOR:
        raise AccuracyError(
            f"the harmonics of the cycle do not die out: after {n // 2} of them the rest is {tail:.3g} of the whole",
            where=where,
            value=tail,
            limit=FLOOR,
            remedy="the motion has a kink or nearly one, a dead point or a limit position; keep clear of it",
        )
    return _series(c, unit), tail


def _series(c: Complex, unit: Values) -> tuple[Series, ...]:
    """Rows of a transform as series, cut where all that follows is rounding."""
    n = c.shape[-1]
    size = np.max(np.abs(c) / unit, axis=0)
    folded = np.maximum(size[: n // 2], np.roll(size[::-1], 1)[: n // 2])
    large = np.flatnonzero(folded > NEGLIGIBLE)
    highest = int(large[-1]) if large.size else 0
    orders = np.arange(-highest, highest + 1)
    return tuple(Series(row[orders]) for row in c)


def crests(series: Series, part: float = 0.0) -> tuple[Values, Values]:
    """Places (m,) and heights (m,) of the local maxima of |f| that reach ``part`` of the largest.

    Where |f| is constant there may be none, or some that rounding makes.
    """
    n = 2 ** math.ceil(math.log2(FINENESS * (2 * series.highest + 1)))
    slope, orders = series.slope(), series.orders
    z, dz = series.even(n), slope.even(n)
    growth = (np.conj(z) * dz).real
    rising, height = growth > 0, np.abs(z)
    tall = np.maximum(height, np.roll(height, -1)) >= part * np.max(height)
    cell = np.flatnonzero(rising & ~np.roll(rising, -1) & tall)
    if not cell.size:
        return np.empty(0), np.empty(0)
    both = np.stack((series.coefficients, slope.coefficients), axis=1)

    def growing(t: Values, _: Indices) -> Values:
        f = _values(t, orders, both)
        return (np.conj(f[:, 0]) * f[:, 1]).real

    step, low, high = TURN / n, growth[cell], growth[(cell + 1) % n]
    first = (cell + low / (low - high)) * step
    at = bracketed(growing, cell * step, (cell + 1) * step, known=(low, high, first))
    return at, np.abs(series.at(at))


def _values(t: Values, orders: NDArray[np.int_], coefficients: Complex) -> Complex:
    """Sums of ``coefficients`` (k,) or (k, f) over the orders (k,), at angles (m,): (m,) or (m, f)."""
    rows = max(1, BLOCK // len(orders))
    parts = [t[i : i + rows] for i in range(0, max(len(t), 1), rows)]
    return np.concatenate([np.exp(1j * np.multiply.outer(part, orders)) @ coefficients for part in parts])


def magnitude(series: Series) -> Magnitude:
    """Root mean square and largest value of |f|, the largest to full precision; of equal ones the first."""
    at, height = crests(series, 0.9)
    largest = float(np.max(height, initial=series.rms))
    if largest <= series.rms * (1 + SAME):  # constant: no place is the largest
        return Magnitude(series.rms, largest, 0.0)
    at = np.where(at > TURN - SAME, 0.0, at)
    return Magnitude(series.rms, largest, float(np.min(at[height >= largest * (1 - SAME)])))
