"""Two stages with a common axis, wheels 2 and 2' on a layshaft or on a carrier: coaxial, AI, AA, II.

    coaxial, AA    mu1 (Z1 + Z2) = mu2 (Z2' + Z3)      U = Z2 Z3/(Z1 Z2')                      (4.10, 4.14)
    AI             mu1 (Z1 + Z2) = mu2 (Z3 - Z2')                                               (4.21)
    II             mu1 (Z1 - Z2) = mu2 (Z3 - Z2')

Wheels 1 and 2 are free. The coaxiality gives the sum (or difference) of the last pair, and the ratio the least and the
greatest number of teeth of its pinion, both by integer division; so each pair of the wheels 1 and 2 costs a few
operations however many wheels follow.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.scheme import PINION, RING, WHEEL, Layout, Lengths, Teeth, around_planets, mesh

if TYPE_CHECKING:
    from tmmcalc.gears.model import Integers, TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """The sums of both stages by coaxiality, the pinion 2' by the ratio, wheel 3 by its sum."""
    import numpy as np

    from tmmcalc.gears.search.blocks import begin, closed, number_between, numbers, spread

    wheels, side = numbers(task), _side(task)
    start = begin(task, proportion, tally, wheels)
    others = len(wheels["2'"]) * len(wheels["3"])
    tally.remove("coaxiality", len(start) * others)
    sums = start["1"] - start["2"] if "1" in task.scheme.rings else start["1"] + start["2"]
    for block in closed(task, start, sums, "sum"):
        low, high = _partners(task, block["sum"], wheels)
        tally.remove("coaxiality", -number_between(low, high))
        least, most = _pinions_of_ratio(task, block)
        tally.remove("ratio", number_between(low, high))
        low, high = np.maximum(low, least), np.minimum(high, most)
        tally.remove("ratio", -number_between(low, high))
        for grown in spread(block, "2'", low, high):
            yield grown.join(**{"3": grown["sum"] + side * grown["2'"]})


def _side(task: TrainTask) -> int:
    """Whether wheel 3 is the sum of the last pair plus (ring) or minus (external) its pinion."""
    return 1 if "3" in task.scheme.rings else -1


def _partners(task: TrainTask, sums: Integers, wheels: dict[str, range]) -> tuple[Integers, Integers]:
    """The least and the greatest pinion 2' for which both wheels of the last pair keep their limits."""
    import numpy as np

    small, large = wheels["2'"], wheels["3"]
    if _side(task) > 0:
        low, high = large.start - sums, large.stop - 1 - sums
    else:
        low, high = sums - large.stop + 1, sums - large.start
    return np.maximum(low, small.start), np.minimum(high, small.stop - 1)


def _pinions_of_ratio(task: TrainTask, block: Block) -> tuple[Integers, Integers]:
    """The least and the greatest Z2' within the ratio: Z2 (S +- Z2')/(Z1 Z2') falls with Z2' (4.16)."""
    import numpy as np

    from tmmcalc.gears.exact import edges

    side = _side(task)
    limits = edges(task.ratio, int(block["1"].max(initial=1)) * task.limits.largest)
    product = block["2"] * block["sum"]
    (low, below), (high, beneath) = limits.low, limits.high
    for_low, for_high = low * block["1"] - side * below * block["2"], high * block["1"] - side * beneath * block["2"]
    most = np.where(for_low > 0, product * below // np.maximum(for_low, 1), task.limits.largest_ring)
    least = np.where(for_high > 0, -(-product * beneath // np.maximum(for_high, 1)), task.limits.largest_ring + 1)
    return least, most


def external_assembly(teeth: Teeth, planets: int) -> list[tuple[Any, Any]]:
    """R of two external (or two internal) meshes (4.25)."""
    import numpy as np

    common = planets * np.gcd(teeth["2"], teeth["2'"])
    return [(teeth["2"] * teeth["3"] - teeth["1"] * teeth["2'"], common)]


def internal_assembly(teeth: Teeth, planets: int) -> list[tuple[Any, Any]]:
    """R of an external and an internal mesh (4.25)."""
    import numpy as np

    common = planets * np.gcd(teeth["2"], teeth["2'"])
    return [(teeth["2"] * teeth["3"] + teeth["1"] * teeth["2'"], common)]


def across_layshafts(teeth: Teeth, m: Lengths, stretch: Lengths, planets: int) -> Any:
    """D of one layshaft (4.50), else the circle around all of them."""
    if planets > 1:
        return around_planets(teeth, m, stretch, planets)
    return (m[0] * ((teeth["1"] + teeth["2"]) * stretch[0] + teeth["2"]) + m[1] * teeth["3"]) / 2


def larger_ring(teeth: Teeth, m: Lengths, stretch: Lengths, planets: int) -> Any:
    """D of two rings: the pitch circle of the larger one."""
    import numpy as np

    return np.maximum(m[0] * teeth["1"], m[1] * teeth["3"])


BLOCK = ("1", "2", "2'", "3")
EXTERNAL_LETTERS = ("(Z2*Z3 - Z1*Z2')/(K*gcd(Z2, Z2'))",)
MOVING = {"1": PINION, "2": WHEEL, "2'": PINION}

COAXIAL = Layout(
    "coaxial",
    "two stages in coaxial layout",
    "coaxial",
    BLOCK,
    (mesh("1", "2", 0), mesh("2'", "3", 1)),
    candidates,
    {**MOVING, "3": WHEEL},
    planets=("2", "2'"),
    planetary=False,
    assembly=external_assembly,
    assembly_letters=EXTERNAL_LETTERS,
    size=across_layshafts,
    lone_size_letters="a_12 + (m_1*Z2 + m_2*Z3)/2",
    arrangements=(5, 4),
    stepped=True,
    usual_planets=1,
)
AI = Layout(
    "AI",
    "double planets, external and internal mesh",
    "AI",
    BLOCK,
    (mesh("1", "2", 0), mesh("2'", "3", 1, "I")),
    candidates,
    MOVING,
    +1,
    ("2", "2'"),
    ("3",),
    fixed="3",
    assembly=internal_assembly,
    assembly_letters=("(Z2*Z3 + Z1*Z2')/(K*gcd(Z2, Z2'))",),
    stepped=True,
)
AA = Layout(
    "AA",
    "double planets, two external meshes",
    "AA",
    BLOCK,
    (mesh("1", "2", 0), mesh("2'", "3", 1)),
    candidates,
    MOVING,
    -1,
    ("2", "2'"),
    fixed="3",
    assembly=external_assembly,
    assembly_letters=EXTERNAL_LETTERS,
    stepped=True,
    carrier="left",
)
II = Layout(
    "II",
    "double planets, two internal meshes",
    "II",
    BLOCK,
    (mesh("1", "2", 0, "I"), mesh("2'", "3", 1, "I")),
    candidates,
    # inside a ring with no sun beside it a planet is a pinion, being the smaller of its pair
    {"1": RING, "2": PINION, "2'": PINION},
    -1,
    ("2", "2'"),
    ("1", "3"),
    fixed="3",
    assembly=external_assembly,
    assembly_letters=EXTERNAL_LETTERS,
    size=larger_ring,
    size_letters="max(m_1*Z1, m_2*Z3)",
)
