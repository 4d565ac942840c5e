"""Numbers as people read them: the same decimals down a column, no noise where a value is zero."""

from __future__ import annotations

import math
from collections.abc import Sequence

DIGITS = 6  # significant digits of the largest value of a column
NOISE = 1e-12  # a value this small against the largest of its column is zero


def number(value: float, digits: int = 7) -> str:
    """One number, ``digits`` significant digits at most."""
    text = f"{value:.{digits}g}"
    return "0" if text == "-0" else text


def column(values: Sequence[float]) -> list[str]:
    """A column with common decimals, or in powers of ten where it is very large or small."""
    largest = max((abs(v) for v in values), default=0.0)
    if largest == 0:
        return ["0"] * len(values)
    exponent = math.floor(math.log10(largest))
    cleaned = [0.0 if abs(v) < NOISE * largest else v for v in values]
    if not -4 <= exponent <= 7:
        return [f"{v:.{DIGITS - 1}e}" if v else "0" for v in cleaned]
    decimals = max(0, DIGITS - 1 - max(exponent, -1))
    return [_plain(v, decimals) for v in cleaned]


def _plain(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text
