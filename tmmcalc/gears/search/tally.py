"""How many candidates each constraint removes, in the order in which they are put."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.search.blocks import Block


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
