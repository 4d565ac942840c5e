"""Formulas of trains as texts: in letters, and the same with numbers in their places.

A letter is a name such as ``Z2'``, ``mu_1``, ``omega_sun``; products have their ``*`` and powers ``**``, so that a text
with its numbers is an arithmetic expression.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

LETTER = re.compile(r"[A-Za-z]\w*(?:'\w*)*")
DIGITS = 9  # of a number within a formula


def teeth_of(wheel: str) -> str:
    """The letter of the number of teeth of a wheel.

    >>> teeth_of("2'"), teeth_of("sun")
    ("Z2'", 'Z_sun')
    """
    return f"Z{wheel}" if wheel[0].isdigit() else f"Z_{wheel}"


def filled(formula: str, numbers: Mapping[str, float]) -> str:
    """The formula with the numbers of its letters, a negative one in brackets; other names stay.

    >>> filled("(Z2*Z3 + Z1*Z2')/(K*gcd(Z2, Z2'))", {"Z1": 22, "Z2": 118, "Z2'": 17, "Z3": 97, "K": 3})
    '(118*97 + 22*17)/(3*gcd(118, 17))'
    """

    def number(match: re.Match[str]) -> str:
        value = numbers.get(match[0])
        if value is None:
            return match[0]
        text = f"{value + 0.0:.{DIGITS}g}"  # no -0
        return f"({text})" if value < 0 else text

    return LETTER.sub(number, formula)
