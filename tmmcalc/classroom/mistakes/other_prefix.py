"""A kilo or a mega of the unit is forgotten, or too much."""

from __future__ import annotations

from tmmcalc.classroom.unitslips import prefixes_swapped
from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value * prefixes_swapped(asked.unit)


MISTAKE = Mistake(
    "a kilo or a mega of the unit is lost, or too much",
    "Look at the unit that is asked for, and at what kilo and mega stand for.",
    SOMETIMES,
    reads=_reads,
)
