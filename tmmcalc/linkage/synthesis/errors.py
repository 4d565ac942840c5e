"""How far the sizes of designs are from those that do exactly what is asked.

A residual says nothing of that: where a linkage only just turns, or precision points lie close together, small
residuals leave much of the sizes open. What the sizes have to keep is therefore written as equations, and corrections
of Newton's, with residuals in extended precision, lead from the sizes told to those that keep them; of a family to the
nearest member. Lengths are judged against the longest of the design, angles by a radian.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.extended import CHAIN, EPS, WIDER
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.posesearch import NEAREST
from tmmcalc.linkage.synthesis.results import Design, Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask

CORRECTIONS = 2
STEP = 1e-7  # of the differences in extended precision, of unknowns of unit size
RANK = 1e-12  # of the largest singular value of the slopes: below it the equations leave a family
MARGIN = 2.0  # of the correction, for what is left of it

Equations = Callable[[Real], Real]  # unknowns (p,) -> what they miss (q,), in the numbers of the unknowns


class Conditions(NamedTuple):
    """What the sizes of a design have to keep, in unknowns of unit size."""

    equations: Equations
    found: Sequence[Any]  # (p,) the unknowns as they are told
    sizes: int  # how many of them are sizes; the rest stands between sizes and equations


_HOME = "tmmcalc.linkage.synthesis"
_OF = {  # kind -> "module:function", called as function(task, design), None where nothing is exact
    "slider_crank": f"{_HOME}.conditions:slider_crank",
    "slotted_link": f"{_HOME}.conditions:slotted_link",
    "rotating_slotted_link": f"{_HOME}.conditions:rotating_slotted_link",
    "crank_rocker": f"{_HOME}.conditions:crank_rocker",
    "trailing_rod": f"{_HOME}.conditions:trailing_rod",
    "path": f"{_HOME}.positionconditions:posed",
    "motion": f"{_HOME}.positionconditions:posed",
    "function": f"{_HOME}.positionconditions:generated",
}


def sizes_error(task: SynthesisTask, found: Synthesis) -> float | None:
    """The largest estimate of all designs; None for fits and searches, which no equations settle."""
    if task.kind not in _OF or found.rule == NEAREST:
        return None
    from importlib import import_module

    module, _, name = _OF[task.kind].partition(":")
    conditions: Callable[[SynthesisTask, Design], Conditions | None] = getattr(import_module(module), name)
    made = [each for design in found.designs if (each := conditions(task, design)) is not None]
    if len(made) < len(found.designs):
        return None
    return max((missed(each) for each in made), default=0.0)


def missed(conditions: Conditions) -> float:
    """Distance of the sizes told from those that keep the conditions, with its margin.

    >>> missed(Conditions(lambda x: x**2 - 2, [1.4142135], 1)) > 6.2e-8
    True
    """
    told = np.array(conditions.found, np.longdouble)
    x = told.copy()
    for _ in range(CORRECTIONS):
        with np.errstate(invalid="ignore"):
            slopes, open_ = _slopes(conditions.equations, x).astype(float), conditions.equations(x).astype(float)
        if not (np.all(np.isfinite(slopes)) and np.all(np.isfinite(open_))):
            return 1.0  # sizes so far apart that a step beside one of them leaves the mechanism: nothing is known
        x = x - np.linalg.lstsq(slopes, open_, rcond=RANK)[0]
    away = float(np.max(np.abs(x - told)[: conditions.sizes]))
    return MARGIN * away + (EPS if WIDER else CHAIN)


def _slopes(f: Equations, x: Real) -> Real:
    columns = [(f(x + STEP * e) - f(x - STEP * e)) / (2 * STEP) for e in np.eye(len(x))]
    return np.stack(columns, axis=1)
