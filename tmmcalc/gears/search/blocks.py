"""Blocks of candidates: many tooth sets as one integer array a wheel, grown wheel by wheel."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers

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


def size(low: Integers, high: Integers) -> int:
    """How many numbers lie between the limits, over all candidates."""
    return int(np.maximum(high - low + 1, 0).sum())
