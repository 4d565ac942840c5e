"""The module is given for the pitch, or the pitch for the module: pi is missing or too much."""

from __future__ import annotations

from math import nan, pi

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    what = parse(asked.name).what.rpartition(".")[2]
    if what in ("p_t", "p_bt", "p_tw"):
        return asked.value / pi
    return asked.value * pi if what in ("m", "m_t") and parse(asked.name).stage == "pair" else nan


MISTAKE = Mistake(
    "pi is missing between module and pitch",
    "How does the pitch follow from the module?",
    SOMETIMES,
    reads=_reads,
)
