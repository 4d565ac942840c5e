"""The columns of the trains among which one is chosen."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import Quantity, components, headed
from tmmcalc.gears.columns import stacked_tables
from tmmcalc.gears.selection.results import Selection, SeriesChoice, Weighed
from tmmcalc.gears.strength.columns import BRANCHES

NO, YES = "no", "yes"
FRONT = Quantity("front", "whether the train is on the Pareto front")
RANK = Quantity("rank", "place of the train by the weights, 1 the best")
BOTH = ("I", "II")  # trains in series


def chosen_columns(result: Selection) -> dict[str, np.ndarray]:
    """All trains, one a row: teeth, modules, widths, criteria, front, rank by the weights; i from 1."""
    columns = stacked_tables([columns_of(each) for each in result.variants if len(each.sets)])
    count = len(result.ranking.order)
    rank = np.empty(count, np.int64)
    rank[result.ranking.order] = np.arange(1, count + 1)
    on_front = np.full(count, NO, dtype="<U3")
    on_front[result.front] = YES
    return {"i": np.arange(1, count + 1), **columns, FRONT.key: on_front, RANK.key: rank}


def columns_of(each: Weighed) -> dict[str, np.ndarray]:
    """Teeth, modules, widths and criteria of the trains of one variant."""
    sets, found = each.sets, each.criteria
    stages = range(1, sets.scheme.stages + 1)
    return {
        "layout": np.full(len(sets), sets.layout),
        BRANCHES.key: np.full(len(sets), sets.planets),
        **components(sets, "teeth", wheel=sets.scheme.wheels),
        **components(each, "module", stage=stages),
        **components(each, "width", stage=stages),
        **headed(found, "mass", "inertia", "size", "envelope", "efficiency", "error"),
    }


def pair_columns(pairs: SeriesChoice) -> dict[str, np.ndarray]:
    """The pairs of trains in series that are on their Pareto front."""
    if pairs.front is None or pairs.first is None or pairs.second is None:
        return {}
    teeth = {
        f"{header} {name}": column
        for name, sets in zip(BOTH, (pairs.first, pairs.second), strict=True)
        for header, column in components(sets, "teeth", wheel=sets.scheme.wheels).items()
    }
    return {
        **teeth,
        **components(pairs, "modules", train=BOTH),
        **components(pairs, "widths", train=BOTH),
        **headed(pairs.front, "ratio", "mass", "inertia", "size", "efficiency", "error"),
    }
