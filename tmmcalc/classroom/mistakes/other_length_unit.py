"""Millimetres are given for metres, or metres for millimetres."""

from __future__ import annotations

from tmmcalc.classroom.unitslips import lengths_swapped
from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return asked.value * lengths_swapped(asked.unit)


MISTAKE = Mistake(
    "millimetres and metres are mixed up",
    "Look at the unit: are lengths in millimetres or in metres?",
    OFTEN,
    reads=_reads,
)
