"""Standard modules (Table D.4.8) and their choice for the stages of a train.

Stages of unfolded reducers choose for themselves; where the wheels of two stages turn about common axes the modules
are tied, m1 : m2 = mu1 : mu2 exactly, and standard modules are chosen together. All entries of the table are whole
eighths of a millimetre, so proportions are integers.
"""

from __future__ import annotations

from enum import IntEnum
from functools import cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.model import Integers, Values
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.strength.tables import StandardModule, table

Flags = NDArray[np.bool_]

EIGHTHS = 8000  # of a millimetre in a metre
SLACK = 1e-12  # relative: a module that is met exactly counts as met


class Outcome(IntEnum):
    """How the choice of modules ended."""

    ACCEPTED = 0
    NO_MODULE = 1  # the table ends below what is required
    NO_PAIR = 2  # no standard modules stand in this proportion
    OVERLOADED = 3  # a stage has a smaller module, or a higher stress, than it may
    PROPORTION = 4  # given modules do not stand in the proportion of the train


@cache
def eighths(rows: Literal[1, 2] = 2) -> tuple[int, ...]:
    """Standard modules in eighths of a millimetre, ascending: of the preferred row, or of both."""
    return tuple(sorted(int(entry.module_mm * 8) for entry in table(StandardModule) if entry.row <= rows))


def round_up(required: Values, rows: Literal[1, 2] = 2, underrun: float = 0.0) -> tuple[Values, Flags]:
    """Smallest standard modules [m] of at least ``required`` (1 - underrun) [m], and where there is one.

    Beyond the table the required module stands in its place. Shapes as ``required``. Textbook D.4.8.

    >>> round_up(np.array([1.9627e-3, 6.01e-3]))[0] * 1000
    array([2., 7.])
    """
    series = np.array(eighths(rows)) / EIGHTHS
    at = np.searchsorted(series, _least(required, underrun))
    found = at < len(series)
    return np.where(found, series[np.minimum(at, len(series) - 1)], required), found


def tied(layout: Layout) -> bool:
    """Whether coaxiality ties the modules of the stages."""
    return layout.branched and layout.stages > 1


def choose(required: Values, rows: Literal[1, 2], underrun: float) -> tuple[Values, Integers]:
    """Standard modules (n, stages) [m] of stages that choose for themselves, and the outcome (n,)."""
    module, found = round_up(required, rows, underrun)
    return module, np.where(found.all(axis=1), Outcome.ACCEPTED, Outcome.NO_MODULE)


def choose_tied(
    required: Values, proportion: Integers, rows: Literal[1, 2], underrun: float, *, scale: bool
) -> tuple[Values, Integers]:
    """Standard modules (n, stages) [m] in the ``proportion`` (n, stages), and the outcome (n,).

    With ``scale`` the smallest ones that are enough for all stages; else those that stage 1 asks for, and a train whose
    other stages need more is overloaded. Where there are none the smallest that are enough, not standard.
    """
    module = (required / proportion).max(axis=1, keepdims=True) * proportion
    outcome = np.full(len(required), Outcome.NO_PAIR, dtype=np.int64)
    least = _least(required, underrun)
    left = np.arange(len(required))
    while left.size:
        mu = tuple(proportion[left[0]].tolist())
        same = (proportion[left] == mu).all(axis=1)
        at, left = left[same], left[~same]
        ladder = np.array(_ladder(mu, rows)).reshape(-1, len(mu)) / EIGHTHS
        if not len(ladder):
            continue
        steps = np.stack([np.searchsorted(ladder[:, k], least[at, k]) for k in range(len(mu))], axis=1)
        step = steps.max(axis=1) if scale else steps[:, 0]
        found = step < len(ladder)
        module[at[found]] = ladder[step[found]]
        enough = (module[at] >= least[at]).all(axis=1)
        outcome[at] = np.where(found, np.where(enough, Outcome.ACCEPTED, Outcome.OVERLOADED), Outcome.NO_MODULE)
    return module, outcome


@cache
def _ladder(mu: tuple[int, ...], rows: Literal[1, 2]) -> tuple[tuple[int, ...], ...]:
    """All standard modules in the proportion, in eighths of a millimetre, ascending."""
    series = eighths(rows)
    scaled = [tuple(first * m // mu[0] for m in mu) for first in series if all(first * m % mu[0] == 0 for m in mu)]
    return tuple(modules for modules in scaled if {*modules} <= {*series})


def _least(required: Values, underrun: float) -> Values:
    return required * (1 - underrun) * (1 - SLACK)
