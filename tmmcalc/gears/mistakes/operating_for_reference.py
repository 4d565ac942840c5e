"""The operating pitch circle is taken for the reference circle."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"r": "r_w", "d": "d_w", "a": "a_w", "alpha_t": "alpha_tw", "p_t": "p_tw", "s_t": "s_tw"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "operating pitch circles are taken for reference circles",
    "On which circle are pitch and module those of the rack?",
    SOMETIMES,
    reads=_reads,
)
