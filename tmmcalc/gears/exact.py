"""Exact ratios: decimals as fractions, and limits that a ratio of bounded integers meets without rounding.

In binary floats (6.2 - 0.1) 20 is 122.00000000000001, and the ring of 122 teeth is lost. Every ratio here is therefore
a `fractions.Fraction`. To test many ratios at once in 64-bit integers, the limits are first replaced by the nearest
fractions of bounded terms on the inner side (Stern and Brocot): a ratio with such terms lies within the one pair of
limits if and only if it lies within the other.
"""

from __future__ import annotations

from fractions import Fraction
from math import floor

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, Interval


def fraction(number: str | int | float | Fraction) -> Fraction:
    """The number as it is written: ``"8.15"`` and 8.15 are 163/20, ``"17/3"`` is itself.

    Raises `UsageError` for text that is no number.

    >>> fraction(0.1), fraction("17/3"), fraction("1e-9")
    (Fraction(1, 10), Fraction(17, 3), Fraction(1, 1000000000))
    """
    if isinstance(number, Fraction):
        return number
    try:
        return Fraction(str(number).replace(" ", ""))
    except (ValueError, ZeroDivisionError):
        remedy = 'a decimal number such as "8.15", or a fraction such as "163/20"'
        raise UsageError(f"{number!r} is no number", where="ratio", remedy=remedy) from None


def around(nominal: Fraction, tolerance: Fraction, *, relative: bool) -> Interval:
    """Values within the tolerance of the nominal one, both ends included.

    >>> around(Fraction(5), Fraction(1, 100), relative=True)
    Interval(low=Fraction(99, 20), high=Fraction(101, 20))
    """
    width = abs(nominal) * tolerance if relative else tolerance
    return Interval(nominal - width, nominal + width)


def at_most(limit: Fraction, largest: int) -> Fraction:
    """The greatest fraction not above the limit whose denominator is at most ``largest`` (>= 1).

    >>> at_most(Fraction("3.14159"), 100)
    Fraction(311, 99)
    """
    if limit.denominator <= largest:
        return limit
    low, high = (floor(limit), 1), (floor(limit) + 1, 1)  # low <= limit < high, neighbours of the Stern-Brocot tree
    while True:
        # As many steps towards high as stay at or below the limit, then as many towards low as stay above it.
        steps = _steps(low, high, limit, largest)
        low = (low[0] + steps * high[0], low[1] + steps * high[1])
        back = _steps_back(low, high, limit, largest)
        high = (high[0] + back * low[0], high[1] + back * low[1])
        if low[1] + high[1] > largest:
            return Fraction(*low)


def _steps(low: tuple[int, int], high: tuple[int, int], limit: Fraction, largest: int) -> int:
    """The most k for which (low + k high) is at or below the limit, its denominator within ``largest``."""
    p, q = limit.numerator, limit.denominator
    by_value = (p * low[1] - q * low[0]) // (q * high[0] - p * high[1])
    return int(min(by_value, (largest - low[1]) // high[1]))


def _steps_back(low: tuple[int, int], high: tuple[int, int], limit: Fraction, largest: int) -> int:
    """The most k for which (high + k low) is above the limit, its denominator within ``largest``."""
    p, q = limit.numerator, limit.denominator
    gap, rise = q * high[0] - p * high[1], p * low[1] - q * low[0]
    by_size = (largest - high[1]) // low[1]
    return int(by_size if rise == 0 else min((gap - 1) // rise, by_size))


def at_least(limit: Fraction, largest: int) -> Fraction:
    """The least fraction not below the limit whose denominator is at most ``largest``.

    >>> at_least(Fraction("3.14159"), 100)
    Fraction(22, 7)
    """
    return -at_most(-limit, largest)


def within(interval: Interval, numerator: Integers, denominator: Integers, largest: int) -> np.ndarray:
    """Where numerator/denominator lies within the interval; ``largest`` bounds the denominators (all positive).

    Numerators and denominators are int64; the products stay below 2^63 as long as the numerator times ``largest`` do.
    """
    low, high = at_least(interval.low, largest), at_most(interval.high, largest)
    if low > high:
        return np.zeros(len(numerator), dtype=bool)
    above = numerator * low.denominator >= low.numerator * denominator
    return np.asarray(above & (numerator * high.denominator <= high.numerator * denominator))


@record
class Edges:
    """The admitted ratios as two fractions of small terms, which 64-bit integers meet exactly:

    ``low <= p/q <= high`` for every fraction p/q whose denominator q is bounded; both positive.
    """

    low: tuple[int, int]  # numerator, denominator
    high: tuple[int, int]

    def first(self, product: Integers, divisor: Integers) -> Integers:
        """The least integer n with n divisor/product >= low, that is the ceiling of low product/divisor."""
        number: Integers = -(-self.low[0] * product // (self.low[1] * divisor))
        return number

    def last(self, product: Integers, divisor: Integers) -> Integers:
        """The greatest integer n with n divisor/product <= high."""
        number: Integers = self.high[0] * product // (self.high[1] * divisor)
        return number


def edges(interval: Interval, denominator: int) -> Edges:
    """The edges for fractions whose denominators do not exceed ``denominator``."""
    low, high = at_least(interval.low, denominator), at_most(interval.high, denominator)
    return Edges((low.numerator, low.denominator), (high.numerator, high.denominator))
