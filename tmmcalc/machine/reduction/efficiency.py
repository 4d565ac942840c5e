"""Instant efficiency: what part of the power at one position is useful (textbook 3.36, 3.37 with power for work).

Useful is the power against resisting loads and what is left over; put in is that of driving loads and what a drive has
to add. Of a working machine it is N_c/(N_c + N_F) while loads resist, of an engine (N_d + N_F)/N_d while loads drive
and overcome friction. Elsewhere nothing useful is done and there is no efficiency: at dead centres, on an idle stroke,
where a load of a working machine helps the drive. Weights, springs and inertia give back over a cycle what they take.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Real
from tmmcalc.machine.reduction.results import Contribution, Reduction

LOSSES = ("friction", "damper")
NOTHING = 1e-9  # power below this part of the largest of its kind is none

Flags = NDArray[np.bool_]


def efficiency(result: Reduction) -> tuple[Real, Flags]:
    """Instant efficiency (n,), from 0 to 1, and where there is one (n,); 0 where there is none."""
    loads, losses = _powers(result, ("load",)), _powers(result, LOSSES).sum(axis=0)
    driving, resisting = np.maximum(loads, 0.0).sum(axis=0), np.minimum(loads, 0.0).sum(axis=0)
    total = driving + resisting + losses
    useful, spent = np.maximum(total, 0.0) - resisting, np.maximum(-total, 0.0) + driving
    own = driving if _is_engine(result) else -resisting
    known = (own > NOTHING * _largest(result, ("load",))) & (useful > NOTHING * spent)
    return np.where(known, useful / np.where(known, spent, 1.0), 0.0), known


def _is_engine(result: Reduction) -> bool:
    """Whether the driving loads put more work into a cycle than a drive that gives what is lacking."""
    loads = [c.work for c in result.contributions if c.kind == "load"]
    total = math.fsum((*loads, *(c.work for c in result.contributions if c.kind in LOSSES)))
    return math.fsum(work for work in loads if work > 0) > max(-total, 0.0)


def _powers(result: Reduction, kinds: tuple[str, ...]) -> Real:
    """Powers (causes, n) of all causes of these kinds along the motion [W]."""
    rows = [k for k, contribution in enumerate(result.contributions) if contribution.kind in kinds]
    return np.asarray(result.moment[rows] * result.speed)


def _largest(result: Reduction, kinds: tuple[str, ...]) -> float:
    """Largest power that one cause of these kinds has over the motion [W]."""
    return max((abs(result.speed) * _size(c) for c in result.contributions if c.kind in kinds), default=0.0)


def _size(contribution: Contribution) -> float:
    return max(abs(contribution.least.value), abs(contribution.largest.value))
