"""The value of the other wheel is given."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.gears.readings import other_wheel


def _reads(asked: Asked) -> float:
    return asked.another(other_wheel(asked.name))


MISTAKE = Mistake(
    "the value of the other wheel of the pair is given",
    "Which of the two wheels is asked for?",
    SOMETIMES,
    reads=_reads,
)
