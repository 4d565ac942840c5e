"""The mass of the rim is taken from its mean radius where the formula has the mean diameter."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    return asked.value / 4 if parse(asked.name).what in ("rim_mass", "rim_thin_mass") else nan


MISTAKE = Mistake(
    "the diameter is taken for the radius in the mass of the rim",
    "Is it the radius or the diameter of the rim that stands squared in the formula of its mass?",
    SOMETIMES,
    reads=_reads,
)
