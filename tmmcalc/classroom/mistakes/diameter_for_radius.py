"""The diameter is given for the radius."""

from __future__ import annotations

import re
from math import nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake

WORD = re.compile(r"\bradi(?:us|i)\b")


def _reads(asked: Asked) -> float:
    return 2 * asked.value if WORD.search(asked.meaning) else nan


MISTAKE = Mistake(
    "the diameter is given for the radius",
    "Is the radius asked for or the diameter?",
    OFTEN,
    reads=_reads,
)
