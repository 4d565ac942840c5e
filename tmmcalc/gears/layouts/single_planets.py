"""Single planets between sun and ring: AIbar.

Z1 + Z2 = Z3 - Z2                    U = Z3/Z1                               (4.24)
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.scheme import PINION, WHEEL, Layout, Teeth, mesh

if TYPE_CHECKING:
    from tmmcalc.gears.model import Integers, TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """The ring by the ratio, the planet by coaxiality."""
    import numpy as np

    from tmmcalc.gears.exact import edges
    from tmmcalc.gears.search.blocks import Block, closeness, external, number_between, ring, spread

    suns, rings = external(task), ring(task)
    tally.begin(len(suns) ** 2 * len(rings))
    sun = Block({"1": np.arange(suns.start, suns.stop)}, proportion)
    limits = edges(task.ratio, max(suns.stop - 1, 1))
    low = np.maximum(limits.first(sun["1"], np.ones_like(sun["1"])), rings.start)
    high = np.minimum(limits.last(sun["1"], np.ones_like(sun["1"])), rings.stop - 1)
    tally.remove("ratio", (len(suns) * len(rings) - number_between(low, high)) * len(suns))
    for block in spread(sun, "3", low, high):
        tally.remove("coaxiality", len(block) * len(suns))
        # Z2 between the roots of (Z1 + Z2) = c (Z3 - Z2) and c (Z1 + Z2) = Z3 - Z2
        least, most = _between(block["3"], block["1"], closeness(task))
        least, most = np.maximum(least, suns.start), np.minimum(most, suns.stop - 1)
        for grown in spread(block, "2", least, most):
            tally.remove("coaxiality", -len(grown))
            total = task.limits.largest_sum
            yield grown if total is None else tally.keep("largest_sum", grown, grown["1"] + grown["2"] <= total)


def _between(outer: Integers, inner: Integers, c: float) -> tuple[Integers, Integers]:
    """Planets between two wheels whose centre distances differ by c at most; c = 1: (outer - inner)/2 if whole."""
    import numpy as np

    from tmmcalc.gears.search.blocks import SLACK

    if c == 1.0:
        return -((inner - outer) // 2), (outer - inner) // 2
    low, high = (c * outer - inner) / (1 + c), (outer - c * inner) / (1 + c)
    return np.ceil(low - SLACK).astype(np.int64), np.floor(high + SLACK).astype(np.int64)


def tooth_ratio(teeth: Teeth) -> tuple[Any, Any]:
    """U = Z3/Z1."""
    return teeth["3"], teeth["1"]


def assembly(teeth: Teeth, planets: int) -> list[tuple[Any, Any]]:
    """R = (Z1 + Z3)/K (4.26)."""
    return [(teeth["1"] + teeth["3"], planets)]


AIBAR = Layout(
    "AIbar",
    "single planets between sun and ring",
    "AI\u0304",
    ("1", "2", "3"),
    (mesh("1", "2", 0), mesh("2", "3", 0, "I")),
    candidates,
    {"1": PINION, "2": WHEEL},
    +1,
    ("2",),
    ("3",),
    fixed="3",
    tooth_ratio=tooth_ratio,
    assembly=assembly,
    ratio_letters="Z3/Z1",
    assembly_letters=("(Z1 + Z3)/K",),
)
