"""A full turn of 2 pi is lost."""

from __future__ import annotations

from math import pi

from tmmcalc.core.mistake import SELDOM, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value / (2 * pi)


MISTAKE = Mistake(
    "a factor of 2 pi, a full turn, is lost",
    "Look for a full turn, 2 pi, in the formula.",
    SELDOM,
    reads=_reads,
)
