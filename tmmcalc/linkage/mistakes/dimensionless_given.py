"""The value is given in parts of the crank: lengths are not multiplied by l_1 (textbook table D.2.1)."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.linkage.readings import analogue, is_length, length_of_crank


def _reads(asked: Asked) -> float:
    if is_length(asked.name):
        return asked.value / asked.scale / length_of_crank(asked)
    name = analogue(asked.name)
    return asked.another(name) / asked.scale / length_of_crank(asked) if name and is_length(name) else nan


MISTAKE = Mistake(
    "the dimensionless value is given, in parts of the crank",
    "The values of your table may be dimensionless: by what do they have to be multiplied?",
    SOMETIMES,
    reads=_reads,
)
