"""Figures of many steady motions at once."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.quantity import quantities
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.stacked.regimes import Machines, Regimes

FIELDS = ("delta", "omega_min", "omega_max", "mean", "time_mean", "cycle_time", "mean_moment", "mean_power")
FIGURES = tuple(quantities(Regime)[name].name for name in FIELDS)


def figures(found: Regimes) -> dict[str, Values]:
    """Figures (V,) of the regimes, under their names as `Regime` declares them."""
    m = found.machines
    low, high = _extremes(m, found.omega)
    r, period = rule(ORDER), np.sum(m.width, axis=1)
    time, work = (np.einsum("vkn,n,vk->v", v, r.weights, m.width) for v in (1 / found.omega, found.driving))
    values = (
        (high - low) / ((high + low) / 2),
        low,
        high,
        (high + low) / 2,
        period / time,
        time,
        work / period,
        work / time,
    )
    return dict(zip(FIGURES, values, strict=True))


def _extremes(m: Machines, omega: Values) -> tuple[Values, Values]:
    """Least and largest speed (V,)."""
    there = m.width > 0
    owner = np.nonzero(there)[0]
    row = omega[there]
    # all panels one behind the other, each of the width one
    at, values = Panels(np.arange(len(row) + 1.0)).turning(row)
    own = owner[np.minimum(at.astype(int), len(row) - 1)]
    ends = np.concatenate([row @ end for end in rule(ORDER).ends])
    low, high = np.full(len(omega), np.inf), np.zeros(len(omega))
    inner = slice(0, len(at) - len(ends))
    for which, found in ((own[inner], values[inner]), (np.tile(owner, 2), ends)):
        np.minimum.at(low, which, found)
        np.maximum.at(high, which, found)
    return low, high
