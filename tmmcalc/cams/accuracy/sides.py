"""Angles of the turn with the pieces of the law on both sides of them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.laws.law import Indices
from tmmcalc.cams.program import Program
from tmmcalc.core.numerics.fourier import TURN
from tmmcalc.core.plane import Real
from tmmcalc.core.studies.sampled import BESIDE, on_edges


def beside(program: Program, phi: Real) -> Iterator[tuple[Real, Indices]]:
    """Angles (m,) of the turn, and numbers of the pieces of the law just before them; then those just behind.

    They differ at the ends of a piece alone: the end of the turn belongs to the last piece, its beginning to the first.
    """
    within = on_edges(np.mod(phi, TURN), program.edges)
    for side in (-BESIDE, BESIDE):
        there = np.mod(within + side, TURN)
        yield within + TURN * np.rint((there - within) / TURN), program.piece(there)
