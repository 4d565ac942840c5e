"""Degrees are given for radians, or radians for degrees."""

from __future__ import annotations

from tmmcalc.classroom.unitslips import angles_swapped
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value * angles_swapped(asked.unit)


MISTAKE = Mistake(
    "degrees and radians are mixed up",
    "Look at the unit: is the angle in degrees or in radians?",
    OFTEN,
    reads=_reads,
)
