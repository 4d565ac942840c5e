"""What rounding leaves of the criteria: those of some trains again in extended precision.

All of them are sums of positive terms but the efficiency, which loses digits where the train nearly stands still; so
the trains of the least ratios and an even choice of the others are taken.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.extended import apart, spread, widened
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.evaluate import Assumptions, Criteria, evaluate
from tmmcalc.gears.model import ToothSets, Values

CHOSEN = 12  # trains of each kind


@record
class CriteriaError:
    """Relative errors, each to the largest value of the trains looked at."""

    mass: float
    inertia: float
    size: float
    envelope: float
    efficiency: float


def criteria_error(
    sets: ToothSets, module: Values, width: Values, basis: Assumptions, found: Criteria
) -> CriteriaError | None:
    """Largest relative differences of the chosen trains; None without any train."""
    if not len(sets):
        return None
    rows = _rows(found)
    some = replace(
        sets, teeth=sets.teeth[rows], modules=sets.modules[rows], angles=sets.angles[rows].astype(np.longdouble)
    )
    wide = replace(basis, rack=widened(basis.rack))
    exact = evaluate(some, module[rows].astype(np.longdouble), width[rows].astype(np.longdouble), basis=wide)
    names = ("mass", "inertia", "size", "envelope", "efficiency")
    return CriteriaError(*(apart(getattr(found, name)[rows], getattr(exact, name)) for name in names))


def _rows(found: Criteria) -> np.ndarray:
    """The trains of the least ratios, and an even choice."""
    worst = np.argsort(abs(found.ratio), kind="stable")[:CHOSEN]
    return np.array(sorted({*spread(len(found), CHOSEN).tolist(), *worst.tolist()}))
