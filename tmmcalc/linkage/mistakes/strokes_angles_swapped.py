"""The angles of working and idle stroke are swapped."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.linkage.readings import other_stroke


def _reads(asked: Asked) -> float:
    return asked.another(other_stroke(asked.name))


MISTAKE = Mistake(
    "the angles of working and idle stroke are swapped",
    "Which of the two strokes is the working one?",
    SOMETIMES,
    reads=_reads,
)
