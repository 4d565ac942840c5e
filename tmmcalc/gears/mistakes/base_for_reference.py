"""The base circle is taken for the reference circle."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"r": "r_b", "d": "d_b", "p_t": "p_bt"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "the base circle is taken for the reference circle",
    "On which circle are pitch and module those of the rack?",
    SOMETIMES,
    reads=_reads,
)
