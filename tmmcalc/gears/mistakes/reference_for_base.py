"""The reference circle is taken for the base circle (pitch for base)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"r_b": "r", "d_b": "d", "p_bt": "p_t"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "the reference circle is taken for the base circle",
    "Which circle is it that the involute begins at?",
    OFTEN,
    reads=_reads,
)
