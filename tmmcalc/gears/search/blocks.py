"""Blocks of candidates: many tooth sets as one integer array a wheel, grown wheel by wheel, and how many are removed.

With mesh angles the reference centre distances of the stages may differ by the factor c = cos(alpha_max)/cos(alpha_0);
without them c = 1, exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, TrainTask

SLACK = 1e-9  # of the limits that mesh angles set as floats; the angles themselves are tested afterwards
ROWS = 1 << 17  # of a block: some 10 MB in work, whatever the size of the search


@record
class Block:
    """Candidates: tooth numbers (n,) by wheel; the proportion of the modules is one for all, or an array a stage."""

    teeth: dict[str, Integers]
    proportion: tuple[int, ...] | tuple[Integers, ...]

    def __len__(self) -> int:
        """Number of candidates."""
        return len(next(iter(self.teeth.values())))

    def __getitem__(self, wheel: str) -> Integers:
        """Tooth numbers (n,) of a wheel."""
        return self.teeth[wheel]

    def take(self, rows: np.ndarray) -> Block:
        """The candidates of a mask or of indices."""
        return Block({wheel: numbers[rows] for wheel, numbers in self.teeth.items()}, self.proportion)

    def join(self, **teeth: Integers) -> Block:
        """The same candidates with further wheels."""
        return Block({**self.teeth, **teeth}, self.proportion)


def spread(block: Block, wheel: str, low: Integers, high: Integers, rows: int = ROWS) -> Iterator[Block]:
    """Every candidate with every number of teeth of a further wheel from ``low`` to ``high`` (n,), block by block."""
    lengths = np.maximum(high - low + 1, 0)
    ends = np.cumsum(lengths)
    start = 0
    while start < len(lengths):
        before = ends[start - 1] if start else 0
        stop = max(int(np.searchsorted(ends, before + rows, "right")), start + 1)
        length = lengths[start:stop]
        owner = np.repeat(np.arange(start, stop), length)
        if len(owner):
            number = np.arange(before, ends[stop - 1]) - np.repeat(ends[start:stop] - length, length) + low[owner]
            grown = block.take(owner)
            yield Block({**grown.teeth, wheel: number}, block.proportion)
        start = stop


def pairs(first: range, second: range) -> tuple[Integers, Integers]:
    """Every number of one range with every number of the other."""
    one, other = np.arange(first.start, first.stop), np.arange(second.start, second.stop)
    return np.repeat(one, len(other)), np.tile(other, len(one))


def number_between(low: Integers, high: Integers) -> int:
    """How many numbers lie between the limits, over all candidates."""
    return int(np.maximum(high - low + 1, 0).sum())


class Tally:
    """Candidates at the start and the removals by name; all numbers are exact, however large."""

    def __init__(self, counts: bool = True) -> None:
        self.counts = counts  # False: nobody asks for the numbers, so what costs time is left out
        self.candidates = 0
        self.removed: dict[str, int] = {}

    def begin(self, candidates: int) -> None:
        """Further candidates enter."""
        self.candidates += candidates

    def remove(self, constraint: str, number: int) -> None:
        """A constraint removes so many of them."""
        self.removed[constraint] = self.removed.get(constraint, 0) + number

    def keep(self, constraint: str, block: Block, kept: np.ndarray, weight: int = 1) -> Block:
        """The candidates of the mask; each of the others counts ``weight`` times."""
        left = int(np.count_nonzero(kept))
        self.remove(constraint, (len(block) - left) * weight)
        return block if left == len(block) else block.take(kept)

    @property
    def left(self) -> int:
        """Candidates that no constraint has removed."""
        return self.candidates - sum(self.removed.values())


def external(task: TrainTask) -> range:
    """Numbers of teeth of external wheels."""
    return range(task.limits.least, task.limits.largest + 1)


def ring(task: TrainTask) -> range:
    """Numbers of teeth of internal wheels."""
    return range(task.limits.least_ring, task.limits.largest_ring + 1)


def pinion(task: TrainTask) -> range:
    """Numbers of teeth of the pinions of unfolded trains."""
    return range(task.limits.least, min(task.limits.largest_pinion, task.limits.largest) + 1)


def numbers(task: TrainTask) -> dict[str, range]:
    """Numbers of teeth of all wheels."""
    return {wheel: ring(task) if wheel in task.scheme.rings else external(task) for wheel in task.scheme.wheels}


def closeness(task: TrainTask) -> float:
    """c: how much smaller the reference centre distance of a stage may be than that of another."""
    angle = task.demands.largest_angle
    return 1.0 if angle is None else math.cos(angle) / math.cos(task.pressure_angle)


def begin(task: TrainTask, proportion: tuple[int, ...], tally: Tally, wheels: dict[str, range]) -> Block:
    """All pairs of the wheels 1 and 2; every combination of all wheels is a candidate."""
    tally.begin(math.prod(len(numbers) for numbers in wheels.values()))
    first, second = pairs(wheels["1"], wheels["2"])
    block = Block({"1": first, "2": second}, proportion)
    largest = task.limits.largest_sum
    if largest is None:
        return block
    others = math.prod(len(numbers) for wheel, numbers in wheels.items() if wheel not in ("1", "2"))
    return tally.keep("largest_sum", block, first + second <= largest, others)


def closed(task: TrainTask, block: Block, sums: Integers, name: str) -> Iterator[Block]:
    """The sums of the second stage that close with those of the first."""
    mu1, mu2 = block.proportion
    c = closeness(task)
    # two wheels have no more teeth than their limits: modules far apart would ask for sums beyond all integers
    most = 2 * max(task.limits.largest, task.limits.largest_ring)
    within = sums * float(mu1 / mu2) * c <= most + 1
    block, sums = block.take(within), sums[within]
    if c == 1.0:
        exact = (sums * mu1 % mu2 == 0) & (sums > 0)
        yield block.take(exact).join(**{name: sums[exact] * mu1 // mu2})
        return
    ideal = sums * mu1 / mu2
    low = np.ceil(np.maximum(ideal * c, 1) - SLACK).astype(np.int64)
    high = np.floor(ideal / c + SLACK).astype(np.int64)
    yield from spread(block, name, low, np.where(sums > 0, high, 0))
