"""The mass of the rim is that of a full disk, J = m D^2/8, in place of J = m D^2/4."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    return 2 * asked.value if parse(asked.name).what in ("rim_mass", "rim_thin_mass") else nan


MISTAKE = Mistake(
    "the rim is taken for a full disk",
    "Where is the mass of the wheel: at its rim or over the whole of it?",
    SOMETIMES,
    reads=_reads,
)
