"""The admitted ratios as two fractions of small terms, which 64-bit integers meet exactly."""

from __future__ import annotations

from tmmcalc.core.records import record
from tmmcalc.gears.exact import at_least, at_most
from tmmcalc.gears.model import Integers, Interval


@record
class Edges:
    """``low <= p/q <= high`` for every fraction p/q whose denominator q is bounded; both positive."""

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
