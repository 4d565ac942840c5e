"""The reference circle is taken for the operating pitch circle."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"r_w": "r", "d_w": "d", "a_w": "a", "alpha_tw": "alpha_t", "p_tw": "p_t", "s_tw": "s_t"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "reference circles are taken for operating pitch circles",
    "Which circles roll on one another when the wheels are cut with shifts?",
    OFTEN,
    reads=_reads,
)
