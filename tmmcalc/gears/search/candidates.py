"""Candidates that meet the tooth limits, the coaxiality and the ratio: these are solved for, not tried.

Of the wheels of a train all but one or two are free. The coaxiality gives the sum (or difference) of the last pair,
and the ratio the least and the greatest number of teeth of its pinion, both by integer division; so each pair of the
wheels 1 and 2 costs a few operations however many wheels follow. With mesh angles the reference centre distances of
the stages may differ by the factor c = cos(alpha_max)/cos(alpha_0); without them c = 1, exactly.

    coaxial, AA    mu1 (Z1 + Z2) = mu2 (Z2' + Z3)      U = Z2 Z3/(Z1 Z2')                      (4.10, 4.14)
    AI             mu1 (Z1 + Z2) = mu2 (Z3 - Z2')                                               (4.21)
    II             mu1 (Z1 - Z2) = mu2 (Z3 - Z2')
    AIbar          Z1 + Z2 = Z3 - Z2                    U = Z3/Z1                               (4.24)
    AII            Z1 + Z2 = Z3 - Z2 = (Z4 - Z2') mu2/mu1
    2A-AA          Z1 + 2 Z2 + Z3 = Z3 + Z4             U = Z4/Z1
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from tmmcalc.gears.exact import within
from tmmcalc.gears.model import Integers, Interval, TrainTask
from tmmcalc.gears.search.blocks import Block, pairs, size, spread
from tmmcalc.gears.search.edges import edges
from tmmcalc.gears.search.ranges import external, ring
from tmmcalc.gears.search.tally import Tally
from tmmcalc.gears.search.unfolded import unfolded

SLACK = 1e-9  # of the float borders of mesh angles; the angles themselves are tested afterwards


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """Every tooth set within limits, coaxiality and ratio for one proportion of modules, block by block."""
    return _FAMILIES[task.layout](task, proportion, tally)


def closeness(task: TrainTask) -> float:
    """c: how much smaller the reference centre distance of a stage may be than that of another."""
    angle = task.demands.largest_angle
    return 1.0 if angle is None else math.cos(angle) / math.cos(task.pressure_angle)


def _numbers(task: TrainTask, wheel: str) -> range:
    return ring(task) if wheel in task.scheme.rings else external(task)


def _begin(task: TrainTask, proportion: tuple[int, ...], tally: Tally, wheels: dict[str, range]) -> Block:
    """All pairs of the wheels 1 and 2; every combination of all wheels is a candidate."""
    tally.begin(math.prod(len(numbers) for numbers in wheels.values()))
    first, second = pairs(wheels["1"], wheels["2"])
    block = Block({"1": first, "2": second}, proportion)
    largest = task.limits.largest_sum
    if largest is None:
        return block
    others = math.prod(len(numbers) for wheel, numbers in wheels.items() if wheel not in ("1", "2"))
    return tally.keep("largest_sum", block, first + second <= largest, others)


def _double(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """Two stages with a common axis: coaxial, AA, AI, II."""
    wheels = {wheel: _numbers(task, wheel) for wheel in task.scheme.wheels}
    start = _begin(task, proportion, tally, wheels)
    others = len(wheels["2'"]) * len(wheels["3"])
    tally.remove("coaxiality", len(start) * others)
    sums = start["1"] - start["2"] if "1" in task.scheme.rings else start["1"] + start["2"]
    for block in _closed(task, start, sums, "sum"):
        low, high = _partners(task, block["sum"], wheels)
        tally.remove("coaxiality", -size(low, high))
        least, most = _pinions_of_ratio(task, block)
        tally.remove("ratio", size(low, high))
        low, high = np.maximum(low, least), np.minimum(high, most)
        tally.remove("ratio", -size(low, high))
        for grown in spread(block, "2'", low, high):
            yield grown.join(**{"3": grown["sum"] + _side(task) * grown["2'"]})


def _side(task: TrainTask) -> int:
    """Whether wheel 3 is the sum of the last pair plus (ring) or minus (external) its pinion."""
    return 1 if "3" in task.scheme.rings else -1


def _closed(task: TrainTask, block: Block, sums: Integers, name: str) -> Iterator[Block]:
    """The sums of the second stage that close with those of the first."""
    mu1, mu2 = block.proportion
    c = closeness(task)
    if c == 1.0:
        exact = (sums * mu1 % mu2 == 0) & (sums > 0)
        yield block.take(exact).join(**{name: sums[exact] * mu1 // mu2})
        return
    ideal = sums * mu1 / mu2
    low = np.ceil(np.maximum(ideal * c, 1) - SLACK).astype(np.int64)
    high = np.floor(ideal / c + SLACK).astype(np.int64)
    yield from spread(block, name, low, np.where(sums > 0, high, 0))


def _partners(task: TrainTask, sums: Integers, wheels: dict[str, range]) -> tuple[Integers, Integers]:
    """The least and the greatest pinion 2' for which both wheels of the last pair keep their limits."""
    small, large = wheels["2'"], wheels["3"]
    if _side(task) > 0:
        low, high = large.start - sums, large.stop - 1 - sums
    else:
        low, high = sums - large.stop + 1, sums - large.start
    return np.maximum(low, small.start), np.minimum(high, small.stop - 1)


def _pinions_of_ratio(task: TrainTask, block: Block) -> tuple[Integers, Integers]:
    """The least and the greatest Z2' within the ratio: Z2 (S +- Z2')/(Z1 Z2') falls with Z2' (4.16)."""
    side = _side(task)
    limits = edges(task.ratio, int(block["1"].max(initial=1)) * task.limits.largest)
    product = block["2"] * block["sum"]
    (low, below), (high, beneath) = limits.low, limits.high
    for_low, for_high = low * block["1"] - side * below * block["2"], high * block["1"] - side * beneath * block["2"]
    most = np.where(for_low > 0, product * below // np.maximum(for_low, 1), task.limits.largest_ring)
    least = np.where(for_high > 0, -(-product * beneath // np.maximum(for_high, 1)), task.limits.largest_ring + 1)
    return least, most


def _single(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """AIbar: the ring by the ratio, the planet by coaxiality."""
    suns, rings = external(task), ring(task)
    tally.begin(len(suns) ** 2 * len(rings))
    sun = Block({"1": np.arange(suns.start, suns.stop)}, proportion)
    limits = edges(task.ratio, max(suns.stop - 1, 1))
    low = np.maximum(limits.first(sun["1"], np.ones_like(sun["1"])), rings.start)
    high = np.minimum(limits.last(sun["1"], np.ones_like(sun["1"])), rings.stop - 1)
    tally.remove("ratio", (len(suns) * len(rings) - size(low, high)) * len(suns))
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
    if c == 1.0:
        return -((inner - outer) // 2), (outer - inner) // 2
    low, high = (c * outer - inner) / (1 + c), (outer - c * inner) / (1 + c)
    return np.ceil(low - SLACK).astype(np.int64), np.floor(high + SLACK).astype(np.int64)


def _three_centrals(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """AII: the fixed ring 3 and the sum of the last pair by coaxiality, the planet 2' by the ratio."""
    wheels = {wheel: _numbers(task, wheel) for wheel in task.scheme.wheels}
    start = _begin(task, proportion, tally, wheels)
    tally.remove("coaxiality", len(start) * len(wheels["2'"]) * len(wheels["3"]) * len(wheels["4"]))
    c = closeness(task)
    rings = wheels["3"]
    near = start["1"] + 2 * start["2"]
    low = near if c == 1.0 else np.ceil(start["2"] + c * (near - start["2"]) - SLACK).astype(np.int64)
    high = near if c == 1.0 else np.floor(start["2"] + (near - start["2"]) / c + SLACK).astype(np.int64)
    for wide in spread(start, "3", np.maximum(low, rings.start), np.minimum(high, rings.stop - 1)):
        for block in _closed(task, wide, wide["1"] + wide["2"], "sum"):
            small, large = wheels["2'"], wheels["4"]
            low = np.maximum(large.start - block["sum"], small.start)
            high = np.minimum(large.stop - 1 - block["sum"], small.stop - 1)
            tally.remove("coaxiality", -size(low, high))
            tally.remove("ratio", size(low, high))
            least, most = _planets_of_ratio(task, block)
            for grown in spread(block, "2'", np.maximum(low, least), np.minimum(high, most)):
                whole = grown.join(**{"4": grown["sum"] + grown["2'"]})
                exact = whole.take(_three_central_ratio(task, whole))
                tally.remove("ratio", -len(exact))
                yield exact


def _planets_of_ratio(task: TrainTask, block: Block) -> tuple[Integers, Integers]:
    """A little more than the planets 2' within the ratio; 1/i_14 is linear in q = Z2'/(S + Z2')."""
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


def _three_central_ratio(task: TrainTask, block: Block) -> np.ndarray:
    """Where i_14 = Z2 Z4 (Z1 + Z3)/(Z1 (Z2 Z4 - Z3 Z2')) lies within the limits, exactly."""
    numerator = block["2"] * block["4"] * (block["1"] + block["3"])
    denominator = block["1"] * (block["2"] * block["4"] - block["3"] * block["2'"])
    ratio = task.ratio if task.ratio.low > 0 else Interval(-task.ratio.high, -task.ratio.low)
    denominator = denominator if task.ratio.low > 0 else -denominator
    bound = int(np.abs(denominator).max(initial=1))
    inside: np.ndarray = (denominator > 0) & within(ratio, numerator, denominator, bound)
    return inside


def _pairs_of_planets(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """2A-AA: the suns by the ratio, planet 3 free, planet 2 by coaxiality."""
    numbers = external(task)
    count = len(numbers)
    tally.begin(count**4)
    sun = Block({"1": np.arange(numbers.start, numbers.stop)}, proportion)
    limits = edges(task.ratio, numbers.stop - 1)
    one = np.ones_like(sun["1"])
    low = np.maximum(limits.first(sun["1"], one), numbers.start)
    high = np.minimum(limits.last(sun["1"], one), numbers.stop - 1)
    tally.remove("ratio", (count**2 - size(low, high)) * count**2)
    c = closeness(task)
    for suns in spread(sun, "4", low, high):
        for block in spread(suns, "3", np.full(len(suns), numbers.start), np.full(len(suns), numbers.stop - 1)):
            tally.remove("coaxiality", len(block) * count)
            right = block["3"] + block["4"]
            rest = block["1"] + block["3"]
            least = -((rest - right) // 2) if c == 1.0 else np.ceil((right * c - rest) / 2 - SLACK).astype(np.int64)
            most = (right - rest) // 2 if c == 1.0 else np.floor((right / c - rest) / 2 + SLACK).astype(np.int64)
            least, most = np.maximum(least, numbers.start), np.minimum(most, numbers.stop - 1)
            tally.remove("coaxiality", -size(least, most))
            for grown in spread(block, "2", least, most):
                total = task.limits.largest_sum
                yield grown if total is None else tally.keep("largest_sum", grown, grown["1"] + grown["2"] <= total)


_FAMILIES: dict[str, Callable[[TrainTask, tuple[int, ...], Tally], Iterator[Block]]] = {
    "unfolded2": unfolded,
    "unfolded3": unfolded,
    "coaxial": _double,
    "AIbar": _single,
    "AI": _double,
    "AA": _double,
    "II": _double,
    "AII": _three_centrals,
    "2A-AA": _pairs_of_planets,
}
