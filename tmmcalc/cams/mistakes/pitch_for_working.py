"""The pitch curve is taken for the working profile (textbook 5.4)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {"x_w": "x_c", "y_w": "y_c", "R_w": "R_c", "alpha_w": "alpha_c", "r_min": "R0", "rho_w": "rho_c"}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "the pitch curve is taken for the working profile",
    "Which of the two curves does the roller touch, and which one does its centre describe?",
    OFTEN,
    reads=_reads,
)
