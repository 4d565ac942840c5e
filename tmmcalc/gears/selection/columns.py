"""The columns of the trains among which one is chosen."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.joined import joined
from tmmcalc.gears.selection.results import Pairs, Selection, Weighed

NO, YES = "no", "yes"


def chosen_columns(result: Selection) -> dict[str, np.ndarray]:
    """All trains, one a row: teeth, modules, widths, criteria, front, rank by the weights; i from 1."""
    columns = joined([columns_of(each) for each in result.variants if len(each.sets)])
    count = len(result.ranking.order)
    rank = np.empty(count, np.int64)
    rank[result.ranking.order] = np.arange(1, count + 1)
    on_front = np.full(count, NO, dtype="<U3")
    on_front[result.front] = YES
    return {"i": np.arange(1, count + 1), **columns, "front": on_front, "rank": rank}


def columns_of(each: Weighed) -> dict[str, np.ndarray]:
    """Teeth, modules, widths and criteria of the trains of one variant."""
    sets, found = each.sets, each.criteria
    stages = range(sets.scheme.stages)
    return {
        "layout": np.full(len(sets), sets.layout),
        "K": np.full(len(sets), sets.planets),
        **{f"z_{wheel}": sets.of(wheel) for wheel in sets.scheme.wheels},
        **{f"m_{k + 1}[m]": each.module[:, k] for k in stages},
        **{f"b_{k + 1}[m]": each.width[:, k] for k in stages},
        "mass[kg]": found.mass,
        "inertia[kg*m^2]": found.inertia,
        "size[m]": found.size,
        "envelope[m]": found.envelope,
        "efficiency": found.efficiency,
        "error": found.error,
    }


def pair_columns(pairs: Pairs) -> dict[str, np.ndarray]:
    """The pairs of trains in series that are on their Pareto front."""
    if pairs.front is None or pairs.first is None or pairs.second is None:
        return {}
    assert pairs.modules is not None
    assert pairs.widths is not None
    teeth = {
        f"z_{wheel} {name}": sets.of(wheel)
        for name, sets in (("I", pairs.first), ("II", pairs.second))
        for wheel in sets.scheme.wheels
    }
    sizes = {
        f"{symbol}_{name}[m]": values[:, k]
        for symbol, values in (("m", pairs.modules), ("b", pairs.widths))
        for k, name in enumerate(("I", "II"))
    }
    found = pairs.front
    return {
        **teeth,
        **sizes,
        "i": found.ratio,
        "mass[kg]": found.mass,
        "inertia[kg*m^2]": found.inertia,
        "size[m]": found.size,
        "efficiency": found.efficiency,
        "error": found.error,
    }
