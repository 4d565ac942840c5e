"""The transfer function of the follower is given for its velocity or acceleration."""

from __future__ import annotations

from tmmcalc.cams.readings import PER_RADIAN
from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, PER_RADIAN))


MISTAKE = Mistake(
    "the transfer function of the follower is given: it is not multiplied by omega or its square",
    "By what does a transfer function have to be multiplied for a velocity, and for an acceleration?",
    OFTEN,
    reads=_reads,
)
