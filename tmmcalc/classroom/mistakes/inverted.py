"""A ratio is inverted."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return nan if asked.unit else 1 / asked.value


MISTAKE = Mistake(
    "the ratio is inverted",
    "What is over what in this ratio?",
    OFTEN,
    reads=_reads,
)
