"""Which samples keep the constraints, and what another width of one tolerance does to that.

What widening does is told by the linear model on the same samples, so that it costs no evaluation: changes of one part
are multiplied, and results follow by their slopes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.tolerance.sources import Values
from tmmcalc.feasibility.rule import may_hold

Limits = tuple[float | None, float | None]
Holds = Callable[[Values], NDArray[np.bool_]]  # results (n, m) -> whether a sample is good (n,)

LOSS = 0.005  # of the yield that a widening may cost
MOST = 64.0  # times a tolerance: more is as wide as one likes
NARROWED = 0.5  # times a tolerance, for what narrowing gains
LEAST = 0.1  # of the variance that sources have together which matter little
HALVINGS = 30


@record
class Widening:
    """What another width of one part does, by the linear model."""

    name: str
    factor: float  # of its tolerance at which the yield is down by LOSS; MOST: at least that
    gain: float  # in the yield, at half of its tolerance


@record
class Widenings:
    """Of all parts; ``together`` are those of little share, that may all be widened by ``common``."""

    loss: float
    linear_yield: float
    parts: tuple[Widening, ...]  # the most useful to narrow first
    together: tuple[str, ...]
    common: float


@record
class Rule:
    """Constraints by their columns among the results, or given as true or false, and the rule that combines them."""

    rule: str
    limits: dict[str, tuple[int, Limits]]  # name of a constraint: column, limits in the unit of the column
    given: dict[str, bool]

    @property
    def columns(self) -> list[int]:
        """The columns that have limits."""
        return [column for column, _ in self.limits.values()]

    def holds(self, results: Values) -> NDArray[np.bool_]:
        """Whether samples (n, m) keep the rule; one that lacks a constrained result does not."""
        truths = {name: np.full(len(results), held) for name, held in self.given.items()}
        known = np.ones(len(results), bool)
        for name, (column, (low, high)) in self.limits.items():
            value = results[:, column]
            known &= np.isfinite(value)
            within = np.ones(len(value), bool)
            if low is not None:
                within &= value >= low
            if high is not None:
                within &= value <= high
            truths[name] = within
        return np.asarray(may_hold(self.rule, truths, (len(results),)) & known)

    def failing(self, results: Values) -> dict[str, int]:
        """How many samples are beyond the limits of every constraint; those that lack the result count."""
        return {name: int((~Rule(name, {name: told}, {}).holds(results)).sum()) for name, told in self.limits.items()}


def widenings(
    holds: Holds, names: Sequence[str], nominal: Values, changes: Values, shares: Values, loss: float = LOSS
) -> Widenings:
    """By the linear model: ``nominal`` (m,), ``changes`` (n, parts, m) of the results by every part of every sample,
    ``shares`` (m, parts) of the variance.
    """
    whole = nominal + changes.sum(axis=1)
    before = float(holds(whole).mean())

    def at(which: NDArray[np.intp], factor: float) -> float:
        return float(holds(whole + (factor - 1) * changes[:, which].sum(axis=1)).mean())

    every = np.arange(len(names))
    parts = []
    for name, own in zip(names, every[:, None], strict=True):
        factor = _factor(partial(at, own), before - loss)
        parts.append(Widening(name, factor, at(own, NARROWED) - before))
    little = _little(shares)
    common = _factor(partial(at, little), before - loss) if len(little) else 1.0
    order = sorted(range(len(parts)), key=lambda k: (-parts[k].gain, parts[k].factor))
    return Widenings(loss, before, tuple(parts[k] for k in order), tuple(names[k] for k in little), common)


def _factor(told: Callable[[float], float], least: float) -> float:
    """The factor up to which the yield is at least that, by halving of ratios."""
    low, high = 1.0, MOST
    if told(high) >= least:
        return MOST
    for _ in range(HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if told(middle) >= least else (low, middle)
    return low


def _little(shares: Values) -> NDArray[Any]:
    """The parts that have together no more than LEAST of the variance of any result, those of the least share first."""
    largest = shares.max(axis=0, initial=0.0)
    order = np.argsort(largest, kind="stable")
    return np.sort(order[np.cumsum(largest[order]) <= LEAST])
