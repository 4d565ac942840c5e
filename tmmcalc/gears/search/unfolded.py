"""Teeth of unfolded trains.

The last wheel of a candidate follows from the ratio. The limits of the ratio of one stage and of the diameters cut the
wheels early, so what each constraint removes is not seen on the way. It is counted by itself, in the order ratio, ratio
of one stage, diameters: combinations of teeth by their products, and trains of admitted stages by their ratios.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from tmmcalc.gears.exact import Edges, edges, within
from tmmcalc.gears.model import Integers, Interval, TrainTask, Values
from tmmcalc.gears.search.blocks import Block, Tally, external, pinion, spread

ROUNDING = 1e-15  # relative, of a product of three ratios in floats; different ratios of such teeth lie further apart


def unfolded_trains(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """Every set within tooth limits, ratio, ratios of stages and diameters, block by block."""
    stages, demands = task.scheme.stages, task.demands
    small, large = pinion(task), external(task)
    pinions = len(small) if demands.equal_pinions else len(small) ** stages
    tally.begin(pinions * len(large) ** stages)
    limits = edges(task.ratio, max(small.stop - 1, 1) ** stages)
    last = "diameter_band" if demands.diameter_band is not None else "stage_ratio"
    if tally.counts:
        left = _number_by_ratio(small, large, stages, demands.equal_pinions, limits)
        tally.remove("ratio", tally.candidates - left)
        if demands.stage_ratio is not None and demands.diameter_band is not None:
            slow = _number_by_stages(task, limits)
            tally.remove("stage_ratio", left - slow)
            left = slow
        tally.remove(last, left)
    start = Block({"1": np.arange(small.start, small.stop)}, proportion)
    for block in _stage(task, start, limits, 0):
        tally.remove(last, -len(block))
        total = task.limits.largest_sum
        yield block if total is None else tally.keep("largest_sum", block, block["1"] + block["2"] <= total)


def _stage(task: TrainTask, block: Block, limits: Edges, stage: int) -> Iterator[Block]:
    """The trains of all stages; ``block`` has all wheels before the driven one of this stage."""
    names = task.scheme.wheels
    first, second = names[2 * stage : 2 * stage + 2]
    low, high = _steps(task, block[first])
    if stage > 0:
        low, high = _inside(low, high, *_diameters(task, block, stage))
    last = stage == task.scheme.stages - 1
    if last:
        product = np.prod([block[name] for name in names[::2]], axis=0)
        divisor = np.prod([block[name] for name in names[1:-1:2]], axis=0)
        low, high = _inside(low, high, limits.first(product, divisor), limits.last(product, divisor))
    else:
        low, high = _inside(low, high, *_reach(task, block, limits, stage))
    for grown in spread(block, second, low, high):
        kept = grown.take(alike(task, grown, stage)) if stage > 0 and task.demands.diameter_band is not None else grown
        if last:
            yield kept
            continue
        for wide in _pinions(task, kept, names[2 * stage + 2]):
            yield from _stage(task, wide, limits, stage + 1)


def _reach(task: TrainTask, block: Block, limits: Edges, stage: int) -> tuple[Integers, Integers]:
    """A little more than the wheels from which the stages that follow can still bring the ratio."""
    names, small, large = task.scheme.wheels, pinion(task), external(task)
    least, most = large.start / (small.stop - 1), (large.stop - 1) / small.start
    if task.demands.stage_ratio is not None:
        least, most = max(least, 1.0), min(most, float(task.demands.stage_ratio))
    left = task.scheme.stages - 1 - stage
    driver = block[names[2 * stage]].astype(float)
    before = np.prod([block[names[2 * k + 1]] / block[names[2 * k]] for k in range(stage)], axis=0)
    low = limits.low[0] / limits.low[1] / most**left * driver / before
    high = limits.high[0] / limits.high[1] / least**left * driver / before
    most_teeth = float(large.stop)
    low, high = (np.clip(end, 0.0, most_teeth) for end in (low - 1e-6, high + 1e-6))
    return np.floor(low).astype(np.int64), np.ceil(high).astype(np.int64)


def _pinions(task: TrainTask, block: Block, wheel: str) -> Iterator[Block]:
    """Every number of teeth of the next pinion, or that of the first."""
    if task.demands.equal_pinions:
        yield block.join(**{wheel: block["1"]})
        return
    numbers = pinion(task)
    yield from spread(block, wheel, np.full(len(block), numbers.start), np.full(len(block), numbers.stop - 1))


def _inside(low: Integers, high: Integers, least: Integers, most: Integers) -> tuple[Integers, Integers]:
    return np.maximum(low, least), np.minimum(high, most)


def _steps(task: TrainTask, driver: Integers) -> tuple[Integers, Integers]:
    """The least and the greatest wheel for a pinion: the stage slows down, and within the ratio of one stage."""
    numbers, largest = external(task), task.demands.stage_ratio
    low, high = np.full(len(driver), numbers.start), np.full(len(driver), numbers.stop - 1)
    if largest is None:
        return low, high
    steepest = [
        min(z * largest.numerator // largest.denominator, numbers.stop - 1) for z in range(driver.max(initial=0) + 1)
    ]
    return _inside(low, high, driver, np.array(steepest)[driver])


def _diameters(task: TrainTask, block: Block, stage: int) -> tuple[Integers, Integers]:
    """A little more than the wheels that are alike in diameter to the one before: Z3^3 near Z1 Z2^2."""
    numbers, band = external(task), task.demands.diameter_band
    if band is None:
        return np.full(len(block), numbers.start), np.full(len(block), numbers.stop - 1)
    before, wide = (block[name] for name in task.scheme.wheels[2 * stage - 2 : 2 * stage])
    same: Values = np.cbrt(before.astype(float) * wide.astype(float) ** 2)
    low, high = same * max(float(1 - band), 0.0), same * float(1 + band)
    return np.floor(low - 1e-6).astype(np.int64), np.ceil(high + 1e-6).astype(np.int64)


def _number_by_ratio(small: range, large: range, stages: int, equal: bool, limits: Edges) -> int:
    """How many combinations of teeth have their ratio within the limits: the products of wheels below a bound."""
    teeth = np.arange(small.start, small.stop)
    product, times = np.unique(teeth**stages, return_counts=True) if equal else _products(teeth, stages)
    wheels, number = _products(np.arange(large.start, large.stop), stages - 1)
    below = np.concatenate([[0], np.cumsum(np.bincount(wheels, number).astype(np.int64))])  # below[q + 1]: up to q
    total = 0
    for wheel in large:
        last = np.minimum(limits.last(product, np.full_like(product, wheel)), len(below) - 2)
        first = np.clip(limits.first(product, np.full_like(product, wheel)), 0, len(below) - 1)
        total += int((np.maximum(below[last + 1] - below[first], 0) * times).sum())
    return total


def _products(teeth: Integers, factors: int) -> tuple[Integers, Integers]:
    """Distinct products of so many numbers, each any of ``teeth``, and how often each comes."""
    product, times = np.array([1]), np.array([1])
    for _ in range(factors):
        every, weight = np.multiply.outer(product, teeth).ravel(), np.repeat(times, len(teeth))
        product, place = np.unique(every, return_inverse=True)
        times = np.bincount(place, weight).astype(np.int64)
    return product, times


def _number_by_stages(task: TrainTask, limits: Edges) -> int:
    """How many of them have admitted ratios of all stages."""
    if task.demands.equal_pinions:
        return sum(_trains(_ratios(task, np.array([z])), task.scheme.stages, limits) for z in pinion(task))
    teeth = pinion(task)
    return _trains(_ratios(task, np.arange(teeth.start, teeth.stop)), task.scheme.stages, limits)


def _ratios(task: TrainTask, drivers: Integers) -> Values:
    """Ratios of all stages that pinions of these numbers of teeth may have, ascending."""
    low, high = _steps(task, drivers)
    numbers = np.maximum(high - low + 1, 0)
    driver = np.repeat(drivers, numbers)
    wheel = np.arange(numbers.sum()) - np.repeat(np.cumsum(numbers) - numbers, numbers) + np.repeat(low, numbers)
    return np.sort(wheel / driver)


def _trains(ratios: Values, stages: int, limits: Edges) -> int:
    """How many combinations of so many of the ratios have their product within the limits."""
    low, high = limits.low[0] / limits.low[1] * (1 - ROUNDING), limits.high[0] / limits.high[1] * (1 + ROUNDING)
    begun = ratios if stages == 2 else np.sort(np.multiply.outer(ratios, ratios).ravel())
    last, first = np.searchsorted(begun, high / ratios, "right"), np.searchsorted(begun, low / ratios, "left")
    return int((last - first).sum())


def alike(task: TrainTask, block: Block, stage: int) -> np.ndarray:
    """Whether the wheel of this stage and the one before are alike in diameter (4.4, 4.7).

    The modules are taken as m2/m1 = cbrt(U1): the relation of the diameters cbrt(Z2/Z1) Z3/Z2 is compared by its cube.
    """
    band = task.demands.diameter_band or Fraction(0)
    before, wide, _, wheel = (block[name] for name in task.scheme.wheels[2 * stage - 2 : 2 * stage + 2])
    cubes = Interval(max(1 - band, Fraction(0)) ** 3, (1 + band) ** 3)
    below = before * wide**2
    return within(cubes, wheel**3, below, int(below.max(initial=1)))
