"""The projections on both axes are swapped."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.linkage.readings import other_axis


def _reads(asked: Asked) -> float:
    return asked.another(other_axis(asked.name))


MISTAKE = Mistake(
    "the projections on the two axes are swapped",
    "Along which axis is the projection asked for?",
    SOMETIMES,
    reads=_reads,
)
