"""Instant efficiency: what part of the power at one position is useful (textbook 3.36, 3.37 with power for work).

Of a working machine N_c/(N_c + N_F) while its loads resist, of an engine (N_d + N_F)/N_d while its loads drive and
overcome friction. Elsewhere nothing useful is done and there is no efficiency: at dead centres, on an idle stroke,
where a load of a working machine helps the drive. Weights, springs and inertia give back over a cycle what they take.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.reduction.results import Contribution, Reduction

LOSSES = ("friction", "damper")
NOTHING = 1e-9  # power below this part of the largest of its kind is none

Flags = NDArray[np.bool_]


def efficiency(result: Reduction) -> tuple[Real, Flags]:
    """Instant efficiency (n,), from 0 to 1, and where there is one (n,); 0 where there is none."""
    loads, losses = _power(result, ("load",)), _power(result, LOSSES)
    engine = math.fsum(c.work for c in result.contributions if c.kind == "load" or c.kind in LOSSES) > 0
    useful, spent = (loads + losses, loads) if engine else (-loads, -loads - losses)
    known = (useful > NOTHING * _largest(result, ("load",))) & (spent > 0)
    return np.where(known, useful / np.where(known, spent, 1.0), 0.0), known


def _power(result: Reduction, kinds: tuple[str, ...]) -> Real:
    """Power (n,) of all causes of these kinds along the motion [W]."""
    rows = [k for k, contribution in enumerate(result.contributions) if contribution.kind in kinds]
    return np.asarray(result.moment[rows].sum(axis=0) * result.speed)


def _largest(result: Reduction, kinds: tuple[str, ...]) -> float:
    """Largest power that one cause of these kinds has over the motion [W]."""
    return max((abs(result.speed) * _size(c) for c in result.contributions if c.kind in kinds), default=0.0)


def _size(contribution: Contribution) -> float:
    return max(abs(contribution.least.value), abs(contribution.largest.value))
