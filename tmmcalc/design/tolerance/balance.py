"""All tolerances at once, at equal yield: wider where little depends on them, narrower where much does.

The widths follow by a rule from the parts that they have in the variance of what is limited, v_i of the part i:

    cost    the least sum of costs, of which each is as the reciprocal of its tolerance: factors as v_i^(-1/3), which
            is what d/df_i (sum of 1/f_i + lambda sum of v_i f_i^2) = 0 says
    share   every part has an equal share of the variance: factors as v_i^(-1/2)

Their common measure is that at which the linear model, by the samples, has the yield of before. What so was found is
then sampled: the true results decide, and where these have less, all widths are taken back a little.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.design.tolerance.sampling import Estimate
from tmmcalc.design.tolerance.sources import Values

Law = Literal["cost", "share"]
LAWS: tuple[Law, ...] = ("cost", "share")
POWERS = {"cost": -1 / 3, "share": -1 / 2}
WIDEST, NARROWEST = 4.0, 0.25  # times a tolerance
HALVINGS = 40
ROUNDS = 4  # of samples, at most
BACK = 0.97  # of all widths, where the samples have less than the yield of before


@record
class Balance:
    """Factors of all parts in their order, and the yields by the same samples with them and without."""

    law: Law
    factors: Values  # (parts,)
    cost: float  # sum of reciprocals, against that of the tolerances as they are
    before: Estimate
    after: Estimate
    samples: int
    rounds: int


def balanced(
    law: Law,
    shares: Values,
    linear_yield: Callable[[Values], float],
    sampled_yield: Callable[[Values], Estimate],
    samples: int,
) -> Balance:
    """Of parts with ``shares`` (m, parts) of the variance of m limited results, of which each counts as its largest.

    Both yields are functions of the factors (parts,), by samples that do not depend on these.
    """
    count = shares.shape[1]
    weight = np.maximum(shares.max(axis=0), 1e-12) ** POWERS[law]
    ones = np.ones(count)
    least, before = linear_yield(ones), sampled_yield(ones)

    def at(measure: float) -> Values:
        return np.asarray(np.clip(measure * weight, NARROWEST, WIDEST))

    measure = _largest(lambda each: linear_yield(at(each)) >= least, NARROWEST / weight.max(), WIDEST / weight.min())
    rounds = 1
    after = sampled_yield(at(measure))
    while after.value < before.value and rounds < ROUNDS:
        measure *= BACK
        rounds += 1
        after = sampled_yield(at(measure))
    factors = at(measure)
    return Balance(law, factors, float(np.mean(1 / factors)), before, after, samples, rounds)


def _largest(holds: Callable[[float], bool], low: float, high: float) -> float:
    """The largest number at which something holds that holds below, by halving of ratios; ``low`` where none does."""
    if holds(high):
        return high
    for _ in range(HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low
