"""Common divisors and prime factors of tooth numbers, step by step as one writes them down.

Mating tooth numbers without a common factor wear evenly: every tooth of one wheel meets every tooth of the other.
"""

from __future__ import annotations

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record


@record
class Euclid:
    """Euclid's algorithm on two numbers (textbook fig. 4.14)."""

    divisor: int  # greatest common divisor
    quotients: tuple[int, ...]
    remainders: tuple[int, ...]  # the last one is zero


def euclid(a: int, b: int) -> Euclid:
    """The greatest common divisor of two positive numbers, with the quotients and remainders on the way.

    Raises `UsageError` for a number below one.

    >>> euclid(1254, 42)
    Euclid(divisor=6, quotients=(29, 1, 6), remainders=(36, 6, 0))
    """
    _positive(a, 1)
    _positive(b, 1)
    quotients, remainders = [], []
    while b:
        quotient, rest = divmod(a, b)
        quotients.append(quotient)
        remainders.append(rest)
        a, b = b, rest
    return Euclid(a, tuple(quotients), tuple(remainders))


def prime_factors(n: int) -> tuple[int, ...]:
    """The prime factors of n in ascending order, each as often as it divides n (textbook table 4.1).

    Raises `UsageError` for a number below two.

    >>> prime_factors(144), prime_factors(149)
    ((2, 2, 2, 2, 3, 3), (149,))
    """
    _positive(n, 2)
    factors, divisor = [], 2
    while divisor * divisor <= n:
        while n % divisor == 0:
            factors.append(divisor)
            n //= divisor
        divisor += 1
    return (*factors, n) if n > 1 else tuple(factors)


def _positive(n: int, least: int) -> None:
    if n < least:
        raise UsageError(f"{n} is below {least}", where="factors", value=n, limit=least, remedy="give a larger integer")
