"""The value of the next position is given (the neighbour position n + 1)."""

from __future__ import annotations

from tmmcalc.classroom.neighbours import neighbour
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.another(neighbour(asked.name, 1))


MISTAKE = Mistake(
    "the value of the next position, n + 1, is given",
    "Look at the number of the position that is asked for.",
    OFTEN,
    reads=_reads,
)
