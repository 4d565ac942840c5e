"""Double planets between a sun and two rings: AII. Ring 3 stands still, ring 4 is driven.

Z1 + Z2 = Z3 - Z2 = (Z4 - Z2') mu2/mu1        i_14 = Z2 Z4 (Z1 + Z3)/(Z1 (Z2 Z4 - Z3 Z2'))
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.scheme import PINION, RING, WHEEL, Layout, Teeth, mesh

if TYPE_CHECKING:
    import numpy as np

    from tmmcalc.gears.model import Integers, TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """The fixed ring 3 and the sum of the last pair by coaxiality, the planet 2' by the ratio."""
    import numpy as np

    from tmmcalc.gears.search.blocks import SLACK, begin, closed, closeness, number_between, numbers, spread

    wheels = numbers(task)
    start = begin(task, proportion, tally, wheels)
    tally.remove("coaxiality", len(start) * len(wheels["2'"]) * len(wheels["3"]) * len(wheels["4"]))
    c = closeness(task)
    rings = wheels["3"]
    near = start["1"] + 2 * start["2"]
    low = near if c == 1.0 else np.ceil(start["2"] + c * (near - start["2"]) - SLACK).astype(np.int64)
    high = near if c == 1.0 else np.floor(start["2"] + (near - start["2"]) / c + SLACK).astype(np.int64)
    for wide in spread(start, "3", np.maximum(low, rings.start), np.minimum(high, rings.stop - 1)):
        for block in closed(task, wide, wide["1"] + wide["2"], "sum"):
            small, large = wheels["2'"], wheels["4"]
            low = np.maximum(large.start - block["sum"], small.start)
            high = np.minimum(large.stop - 1 - block["sum"], small.stop - 1)
            tally.remove("coaxiality", -number_between(low, high))
            tally.remove("ratio", number_between(low, high))
            least, most = _planets_of_ratio(task, block)
            for grown in spread(block, "2'", np.maximum(low, least), np.minimum(high, most)):
                whole = grown.join(**{"4": grown["sum"] + grown["2'"]})
                exact = whole.take(_within_ratio(task, whole))
                tally.remove("ratio", -len(exact))
                yield exact


def _planets_of_ratio(task: TrainTask, block: Block) -> tuple[Integers, Integers]:
    """A little more than the planets 2' within the ratio; 1/i_14 is linear in q = Z2'/(S + Z2')."""
    import numpy as np

    inverse = sorted((1 / float(task.ratio.low), 1 / float(task.ratio.high)))
    first, planet, fixed = block["1"], block["2"], block["3"]
    turn = (first + fixed) / first  # 1 + Z3/Z1
    q_low, q_high = ((1 - turn * end) * planet / fixed for end in reversed(inverse))
    with np.errstate(divide="ignore"):
        low = np.where(q_low < 1, q_low * block["sum"] / (1 - q_low), math.inf)
        high = np.where(q_high < 1, q_high * block["sum"] / (1 - q_high), math.inf)
    most = task.limits.largest_ring
    least = np.floor(np.clip(low, 0, most + 1) - 1e-6).astype(np.int64)
    return least, np.ceil(np.clip(high, 0, most) + 1e-6).astype(np.int64)


def _within_ratio(task: TrainTask, block: Block) -> np.ndarray:
    """Where i_14 = Z2 Z4 (Z1 + Z3)/(Z1 (Z2 Z4 - Z3 Z2')) lies within the limits, exactly."""
    import numpy as np

    from tmmcalc.gears.exact import within
    from tmmcalc.gears.model import Interval

    numerator = block["2"] * block["4"] * (block["1"] + block["3"])
    denominator = block["1"] * (block["2"] * block["4"] - block["3"] * block["2'"])
    ratio = task.ratio if task.ratio.low > 0 else Interval(-task.ratio.high, -task.ratio.low)
    denominator = denominator if task.ratio.low > 0 else -denominator
    bound = int(np.abs(denominator).max(initial=1))
    inside: np.ndarray = (denominator > 0) & within(ratio, numerator, denominator, bound)
    return inside


def tooth_ratio(teeth: Teeth) -> tuple[Any, Any]:
    """i_14 with its sign, the denominator without."""
    import numpy as np

    numerator = teeth["2"] * teeth["4"] * (teeth["1"] + teeth["3"])
    denominator = teeth["1"] * (teeth["2"] * teeth["4"] - teeth["3"] * teeth["2'"])
    return numerator * np.sign(denominator), abs(denominator)


def assembly(teeth: Teeth, planets: int) -> list[tuple[Any, Any]]:
    """The planets 2 between sun and ring 3, and R of their blocks between both rings (4.25, 4.26)."""
    import numpy as np

    common = planets * np.gcd(teeth["2"], teeth["2'"])
    return [
        (teeth["1"] + teeth["3"], planets),
        (teeth["2"] * teeth["4"] - teeth["3"] * teeth["2'"], common),
    ]


AII = Layout(
    "AII",
    "double planets, a sun and two rings",
    "AII",
    ("1", "2", "2'", "3", "4"),
    (mesh("1", "2", 0), mesh("2", "3", 0, "I"), mesh("2'", "4", 1, "I")),
    candidates,
    # inside a ring with no sun beside it planet 2' is a pinion, being the smaller of its pair
    {"1": PINION, "2": WHEEL, "2'": PINION, "4": RING},
    0,
    ("2", "2'"),
    ("3", "4"),
    fixed="3",
    tooth_ratio=tooth_ratio,
    assembly=assembly,
    ratio_letters="(1 + Z3/Z1)/(1 - Z3*Z2'/(Z2*Z4))",
    assembly_letters=("(Z1 + Z3)/K", "(Z2*Z4 - Z3*Z2')/(K*gcd(Z2, Z2'))"),
    carrier="left",
)
