"""A derivative is given per degree of the angle in place of per radian."""

from __future__ import annotations

from math import nan, pi

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake


def _reads(asked: Asked) -> float:
    power = {"/rad": 1, "/rad^2": 2, "/rad^3": 3}.get(
        asked.unit[asked.unit.find("/rad") :] if "/rad" in asked.unit else ""
    )
    return asked.value * (pi / 180) ** power if power else nan


MISTAKE = Mistake(
    "the derivative is per degree in place of per radian",
    "By which unit of the angle is this a derivative?",
    SOMETIMES,
    reads=_reads,
)
