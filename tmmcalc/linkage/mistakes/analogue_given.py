"""The transfer function is given for the velocity or the acceleration, not multiplied by omega_1."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.linkage.readings import analogue


def _reads(asked: Asked) -> float:
    return asked.another(analogue(asked.name))


MISTAKE = Mistake(
    "the transfer function is given: it is not multiplied by omega or its square",
    "By what does a transfer function have to be multiplied for a velocity, and for an acceleration?",
    OFTEN,
    reads=_reads,
)
