"""The working profile is taken for the pitch curve (textbook 5.4)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"x_c": "x_w", "y_c": "y_w", "R_c": "R_w", "alpha_c": "alpha_w", "R0": "r_min", "rho_c": "rho_w"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "the working profile is taken for the pitch curve",
    "Which of the two curves does the roller touch, and which one does its centre describe?",
    OFTEN,
    reads=_reads,
)
