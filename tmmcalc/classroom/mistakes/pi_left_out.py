"""A factor of pi is lost."""

from __future__ import annotations

from math import pi

from tmmcalc.core.mistake import SELDOM, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value / pi


MISTAKE = Mistake(
    "a factor of pi is lost",
    "Look for pi in the formula.",
    SELDOM,
    reads=_reads,
)
