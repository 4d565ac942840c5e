"""The radius is given for the diameter (digest 08)."""

from __future__ import annotations

from math import nan

from tmmcalc.classroom.sizes import is_diameter
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value / 2 if is_diameter(asked.name) else nan


MISTAKE = Mistake(
    "the radius is given for the diameter",
    "Is the radius asked for or the diameter?",
    OFTEN,
    reads=_reads,
)
