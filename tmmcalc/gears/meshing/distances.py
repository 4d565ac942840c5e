"""Centre distances and sums of shifts at which no pair exists: the nearest ones at which it works."""

from __future__ import annotations

from math import ceil

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.internal.margins import margin_of as ring_margin
from tmmcalc.gears.involute.internal.ring import angle_of_distance, angle_of_shifts, largest_sum
from tmmcalc.gears.involute.pair import pair_of_shifts, sum_of_shifts
from tmmcalc.gears.involute.quality.existence import least_sum, margin_of
from tmmcalc.gears.involute.quality.nearest import Margin, best_split, outermost_sum, told_nearest
from tmmcalc.gears.meshing.geometry import RING_TIPS, ring_of, wheel_of
from tmmcalc.gears.meshing.refusal import place
from tmmcalc.gears.meshing.task import PairTask

FINE = 1e-6  # m, to which a centre distance is rounded
STEPS = (0, 1, 2, 4, 8, 16, 32, 64, 128, 256)  # by which it is rounded farther, where it has to be


def nearest_distance(task: PairTask) -> str:
    """The least centre distance at which the pair works, with shifts for it, in words."""
    fast, exact = _margins(task)
    inner = task.kind == "internal"
    found = outermost_sum(fast, _bound(task), -1.0 if inner else 1.0)
    if found is None:
        return "no centre distance makes this pair possible: other limits"
    first = ceil(_distance(task, *found) / FINE)
    for step in STEPS:
        distance = FINE * (first + step)
        total = _sum(task, distance)
        x1 = round(best_split(fast, total, found[0])[0], 4)
        if exact(np.array([x1]), np.array([total - x1]))[0] >= 0:
            break
    return f"the nearest admissible centre distance is {1e3 * distance:.9g} mm, with x1 = {x1:g}, x2 = {total - x1:.4f}"


def require_sum(task: PairTask, shifts: tuple[float, float]) -> None:
    """Raise `NoSolutionError` if the shifts of an internal pair add up to too much, with the nearest that work."""
    total, limit = shifts[0] + shifts[1], _bound(task)
    if total < limit:
        return
    told = told_nearest(*_margins(task), shifts)
    raise NoSolutionError(
        f"the involute of the operating pressure angle is not positive: x1 + x2 = {total:.6g}, it has to stay below "
        f"{limit:.6g} (margin {limit - total:.4g})",
        where=place(task),
        value=total,
        limit=limit,
        remedy=told or f"x1 + x2 below {limit:.6g}, and a greater difference of the teeth",
    )


def _margins(task: PairTask) -> tuple[Margin, Margin]:
    """The least margin over the shifts, quickly and exactly."""
    if task.kind == "internal":
        return ring_margin(wheel_of(task, 1), ring_of(task), task.limits, task.fillet, RING_TIPS)
    return margin_of(wheel_of(task, 1), wheel_of(task, 2), task.limits, task.fillet)


def _bound(task: PairTask) -> float:
    """x1 + x2 at which the operating pressure angle vanishes."""
    if task.kind == "internal":
        return largest_sum(wheel_of(task, 1), ring_of(task))
    return least_sum(wheel_of(task, 1), wheel_of(task, 2))


def _distance(task: PairTask, x1: float, x2: float) -> float:
    """a_w [m]."""
    first = wheel_of(task, 1, x1)
    if task.kind == "internal":
        return task.module * angle_of_shifts(first, ring_of(task, x2))[1]
    return task.module * float(pair_of_shifts(first, wheel_of(task, 2, x2)).distance)


def _sum(task: PairTask, distance: float) -> float:
    """x1 + x2 of a centre distance [m]."""
    first, a = wheel_of(task, 1), distance / task.module
    if task.kind == "internal":
        return angle_of_distance(first, ring_of(task), a)[0]
    return float(sum_of_shifts(first, wheel_of(task, 2), a)[0])
