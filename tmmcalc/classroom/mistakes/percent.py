"""A part is given in percent."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake


def _reads(asked: Asked) -> float:
    return nan if asked.unit or abs(asked.value) > 1 else 100 * asked.value


MISTAKE = Mistake(
    "percent are given for a part of one",
    "Is this a part of one, or are these percent?",
    SOMETIMES,
    reads=_reads,
)
