"""Pairs of meshing planets between two suns: 2A-AA.

Z1 + 2 Z2 + Z3 = Z3 + Z4             U = Z4/Z1
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.scheme import PINION, WHEEL, Layout, Lengths, MovingWheel, Teeth, mesh

if TYPE_CHECKING:
    from tmmcalc.gears.model import TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """The suns by the ratio, planet 3 free, planet 2 by coaxiality."""
    import numpy as np

    from tmmcalc.gears.exact import edges
    from tmmcalc.gears.search.blocks import SLACK, Block, closeness, external, number_between, spread

    teeth = external(task)
    count = len(teeth)
    tally.begin(count**4)
    sun = Block({"1": np.arange(teeth.start, teeth.stop)}, proportion)
    limits = edges(task.ratio, teeth.stop - 1)
    one = np.ones_like(sun["1"])
    low = np.maximum(limits.first(sun["1"], one), teeth.start)
    high = np.minimum(limits.last(sun["1"], one), teeth.stop - 1)
    tally.remove("ratio", (count**2 - number_between(low, high)) * count**2)
    c = closeness(task)
    for suns in spread(sun, "4", low, high):
        for block in spread(suns, "3", np.full(len(suns), teeth.start), np.full(len(suns), teeth.stop - 1)):
            tally.remove("coaxiality", len(block) * count)
            right = block["3"] + block["4"]
            rest = block["1"] + block["3"]
            least = -((rest - right) // 2) if c == 1.0 else np.ceil((right * c - rest) / 2 - SLACK).astype(np.int64)
            most = (right - rest) // 2 if c == 1.0 else np.floor((right / c - rest) / 2 + SLACK).astype(np.int64)
            least, most = np.maximum(least, teeth.start), np.minimum(most, teeth.stop - 1)
            tally.remove("coaxiality", -number_between(least, most))
            for grown in spread(block, "2", least, most):
                total = task.limits.largest_sum
                yield grown if total is None else tally.keep("largest_sum", grown, grown["1"] + grown["2"] <= total)


def tooth_ratio(teeth: Teeth) -> tuple[Any, Any]:
    """U = Z4/Z1."""
    return teeth["4"], teeth["1"]


def assembly(teeth: Teeth, planets: int) -> list[tuple[Any, Any]]:
    """N = (Z1 + Z4)/K."""
    return [(teeth["1"] + teeth["4"], planets)]


def axes(teeth: Teeth) -> list[Any]:
    """Twice the distances of sun 1 from planet 3 over planet 2, and of sun 4 from planet 3, in modules."""
    return [teeth["1"] + 2 * teeth["2"] + teeth["3"], teeth["3"] + teeth["4"]]


def around_outer(teeth: Teeth, m: Lengths, stretch: Lengths, planets: int) -> Any:
    """D, the circle around the planets 3."""
    return m[0] * ((teeth["3"] + teeth["4"]) * stretch[2] + teeth["3"])


PAIRED = Layout(
    "2A-AA",
    "pairs of meshing planets between two suns",
    "2A-(AA\u0304)",
    ("1", "2", "3", "4"),
    (mesh("1", "2", 0), mesh("2", "3", 0), mesh("3", "4", 0, plane=1)),
    candidates,
    {"1": PINION, "2": WHEEL, "3": MovingWheel("wheel", 2)},  # planet 3 reaches both planes of meshing
    +1,
    ("2", "3"),
    fixed="4",
    tooth_ratio=tooth_ratio,
    assembly=assembly,
    ratio_letters="Z4/Z1",
    assembly_letters=("(Z1 + Z4)/K",),
    axes=axes,
    size=around_outer,
    size_letters="2*a_34 + m_1*Z3",
    raised=math.radians(26),
    carrier="left",
)
