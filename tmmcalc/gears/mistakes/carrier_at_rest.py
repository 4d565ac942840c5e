"""Speeds are those of a train with fixed axes: the carrier is taken as standing still (textbook 4.2)."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    name = parse(asked.name)
    if name.stage == "gearing" and name.what.startswith(("i_1_H", "i_sun_H")):
        return asked.value - 1
    return asked.value - 1 if name.stage in ("train", "criteria") and name.what in ("i_1H", "ratio") else nan


MISTAKE = Mistake(
    "the ratio is that of the train with its carrier at rest",
    "Does the carrier stand still here?",
    OFTEN,
    reads=_reads,
)
