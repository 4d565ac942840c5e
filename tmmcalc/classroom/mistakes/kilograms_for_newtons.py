"""A force is given in kilograms-force in place of newtons: the weight is not multiplied by g."""

from __future__ import annotations

from tmmcalc.classroom.unitslips import forces_in_kilograms
from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value * forces_in_kilograms(asked.unit)


MISTAKE = Mistake(
    "the force is in kilograms in place of newtons: g is missing",
    "Look at the unit of the force: kilograms are not newtons.",
    SOMETIMES,
    reads=_reads,
)
