"""The diameter is given for the radius (digest 08)."""

from __future__ import annotations

from math import nan

from tmmcalc.classroom.sizes import is_radius
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return 2 * asked.value if is_radius(asked.name) else nan


MISTAKE = Mistake(
    "the diameter is given for the radius",
    "Is the radius asked for or the diameter?",
    OFTEN,
    reads=_reads,
)
