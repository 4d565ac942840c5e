"""The radius is given for the diameter."""

from __future__ import annotations

import re
from math import nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake

WORD = re.compile(r"\bdiameters?\b")


def _reads(asked: Asked) -> float:
    return asked.value / 2 if WORD.search(asked.meaning) else nan


MISTAKE = Mistake(
    "the radius is given for the diameter",
    "Is the radius asked for or the diameter?",
    OFTEN,
    reads=_reads,
)
