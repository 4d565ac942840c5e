"""Choice among variants: by one criterion, by weights, from the Pareto front; and why the winner won.

Reasons are numbers, not sentences: the criterion, the winner's value, the runner-up and its value. Words are the
report's affair.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.objectives import OBJECTIVES, Measured
from tmmcalc.gears.criteria.pareto import pareto_front
from tmmcalc.gears.model import Values


@record
class Reason:
    """Why a variant was chosen."""

    criterion: str  # key of an objective, or "weights"
    winner: int  # index
    value: float  # of the criterion
    runner_up: int | None  # index; None: no other variant
    runner_up_value: float | None
    tied: int  # other variants with the same value, later in the list


@record
class Ranking:
    """Variants in the order of their weighted, normalised criteria."""

    weights: dict[str, float]  # of the criteria, their sum one
    order: NDArray[np.intp]  # (n,) indices, the best first
    scores: Values  # (n,) from 0, best in every criterion, to 1
    parts: Values  # (n, k) of the scores, in the order of the weights
    reason: Reason


def costs(measured: Measured, objectives: Sequence[str]) -> Values:
    """Values (n, k) of the criteria so that less is better. Raises `UsageError` for an unknown criterion."""
    columns = [_cost(measured, key) for key in objectives]
    if not columns:
        raise UsageError("no criterion", where="choice", remedy=f"criteria: {', '.join(OBJECTIVES)}")
    return np.stack(columns, axis=1)


def front(measured: Measured, objectives: Sequence[str]) -> NDArray[np.intp]:
    """Indices, ascending, of the variants that no other one dominates in these criteria."""
    return pareto_front(costs(measured, objectives))


def least(measured: Measured, criterion: str) -> Reason:
    """The best variant by one criterion, the first of equals. Raises `NoSolutionError` if there is none."""
    cost = costs(measured, [criterion])[:, 0]
    return _reason(criterion, cost, -cost if OBJECTIVES[criterion].largest else cost)


def minima(measured: Measured, objectives: Sequence[str]) -> tuple[Reason, ...]:
    """The best variant by each of the criteria."""
    return tuple(least(measured, criterion) for criterion in objectives)


def ranked(measured: Measured, weights: Mapping[str, float]) -> Ranking:
    """Variants by the weighted sum of their criteria, each scaled to 0 at its best and 1 at its worst value.

    A criterion in which all are equal counts nothing. Raises `UsageError` for weights that are negative or all zero.
    """
    total = sum(weights.values())
    if not (0 < total < np.inf) or min(weights.values()) < 0:
        raise UsageError(
            "weights are not negative, and not all zero", where="choice", value=total, remedy="weights >= 0"
        )
    share = {key: weight / total for key, weight in weights.items()}
    cost = costs(measured, list(share))
    if not len(cost):
        _refuse_empty()
    low, span = cost.min(axis=0), np.ptp(cost, axis=0)
    parts = (cost - low) / np.where(span > 0, span, 1.0) * np.array(list(share.values()))
    scores = parts.sum(axis=1)
    return Ranking(share, np.argsort(scores, kind="stable"), scores, parts, _reason("weights", scores, scores))


def _cost(measured: Measured, key: str) -> Values:
    if key not in OBJECTIVES:
        raise UsageError(f"no criterion {key!r}", where="choice", remedy=f"criteria: {', '.join(OBJECTIVES)}")
    values: Values = getattr(measured, key)
    return -values if OBJECTIVES[key].largest else values


def _reason(criterion: str, cost: Values, value: Values) -> Reason:
    if not len(cost):
        _refuse_empty()
    order = np.argsort(cost, kind="stable")
    winner = int(order[0])
    second = int(order[1]) if len(order) > 1 else None
    tied = int(np.count_nonzero(cost == cost[winner])) - 1
    return Reason(
        criterion, winner, float(value[winner]), second, None if second is None else float(value[second]), tied
    )


def _refuse_empty() -> None:
    raise NoSolutionError("there is no variant to choose from", where="choice", value=0.0, remedy="widen the synthesis")
