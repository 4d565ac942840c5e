"""In which positions of a reduction something jumps, and which side of the jump it tells."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.machine.motion import Positions
from tmmcalc.machine.nodes import LEVEL, at_speed, both_sides, nodal_tables
from tmmcalc.machine.reduction.results import Reduction

ROUNDING = 1e-12  # of the largest moment of a single cause: nothing but rounding


class Jumps(NamedTuple):
    """Rows of the positions in which moments jump."""

    larger: list[int]  # in which the larger side is told of all that jump
    other: list[int]

    @property
    def rows(self) -> set[int]:
        """All of them."""
        return {*self.larger, *self.other}


def jumps(result: Reduction, *, loads: bool) -> Jumps:
    """Where the moments of the ``loads`` jump, or those of friction."""
    wanted = [k for k, each in enumerate(result.contributions) if each.kind == ("load" if loads else "friction")]
    if not wanted:
        return Jumps([], [])
    parts = result.parts[wanted]
    after, before = both_sides(result.cycle, parts, Positions.of(result).theta)
    least = np.maximum(LEVEL * np.max(np.abs(parts), axis=(1, 2)), ROUNDING * _largest(result))
    jumping = np.abs(after - before) > least[:, None]
    told, sizes = np.abs(result.moment[wanted]), np.abs((after, before))
    larger = np.abs(told - np.max(sizes, axis=0)) < np.abs(told - np.min(sizes, axis=0))
    rows, kept = jumping.any(axis=0), (larger | ~jumping).all(axis=0)
    return Jumps(np.flatnonzero(rows & kept).tolist(), np.flatnonzero(rows & ~kept).tolist())


def nodal_jumps(result: Reduction, speed: float) -> list[int]:
    """Rows in which the textbook's methods, to which the larger load counts at a jump, take another moment.

    Of moments that cancel only what is more than rounding of them is a jump.
    """
    taken, own = nodal_tables(result.cycle, len(result.phi) - 1, speed)[0], Positions.of(result).moment
    assert own is not None
    least = max(LEVEL * float(np.max(np.abs(at_speed(result.cycle, speed)))), ROUNDING * _largest(result))
    return np.flatnonzero(np.abs(taken - own) > least).tolist()


def _largest(result: Reduction) -> float:
    """The largest moment of a single cause."""
    return float(np.max(np.abs(result.parts), initial=0.0))
