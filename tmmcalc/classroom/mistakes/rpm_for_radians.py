"""Revolutions a minute are given for radians a second, or the other way."""

from __future__ import annotations

from tmmcalc.classroom.unitslips import speeds_swapped
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value * speeds_swapped(asked.unit)


MISTAKE = Mistake(
    "rpm and rad/s are mixed up",
    "Look at the unit of the angular velocity.",
    OFTEN,
    reads=_reads,
)
