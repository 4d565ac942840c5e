"""Firing intervals: the shaft angles between the top dead centres of the cylinders in their firing order."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.balance.cylinders import Cylinder

TURN = 2 * math.pi
EVEN = 1e-9  # intervals that differ less [rad] are equal
WHERE = "firing order"


@record
class Firing:
    """A firing order and its intervals over one cycle."""

    order: tuple[int, ...] = quantity("firing_order", "cylinders in the order in which they fire, from 1")
    # the last one: to the first
    intervals: tuple[float, ...] = quantity("firing_intervals[rad]", "from every cylinder to the next")

    @derived("firing_even", "all intervals are equal")
    def even(self) -> bool:
        """Whether all intervals are equal."""
        return max(self.intervals) - min(self.intervals) < EVEN


def firing(cylinders: Sequence[Cylinder], order: Sequence[int], *, strokes: int = 4, sense: int = 1) -> Firing:
    """Intervals [rad] of a firing order, every cylinder firing at the first top dead centre after the one before.

    ``strokes`` of a cycle: 4 or 2. ``sense`` +1: the shaft turns counter-clockwise, -1: clockwise. Top dead centre is
    taken where the crank lies along the cylinder's axis. Raises `UsageError` unless the order names every cylinder
    once, `NoSolutionError` if one cycle does not hold it.
    """
    if strokes not in (2, 4) or sorted(order) != list(range(1, len(cylinders) + 1)):
        text = f"{'-'.join(map(str, order))} with {strokes} strokes does not name all {len(cylinders)} cylinders once"
        raise UsageError(text, where=WHERE, remedy="number the cylinders from 1 as listed; strokes are 2 or 4")
    dead = [sense * (c.axis_angle - c.crank_angle) for c in cylinders]
    along = [dead[i - 1] for i in order]
    intervals = [_ahead(b - a) for a, b in pairwise(along)]
    last = strokes * math.pi - sum(intervals)
    if last < EVEN:
        raise NoSolutionError(
            f"{'-'.join(map(str, order))} takes more than one cycle of {strokes * 180} deg",
            where=WHERE,
            value=math.degrees(sum(intervals)),
            limit=strokes * 180.0,
            remedy="choose an order that suits the throws of the crank",
        )
    return Firing(tuple(order), (*intervals, last))


def _ahead(angle: float) -> float:
    """The angle modulo a turn, in (0, 2 pi]; rounding does not make a whole turn of nothing."""
    rest = angle % TURN
    return TURN if rest < EVEN else rest
