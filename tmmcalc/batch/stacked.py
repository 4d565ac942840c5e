"""Points solved together: variants of one structure as rows of the same arrays.

Of columns and a few facts the values are made at once (`stacked_columns`), of all else the results of every variant by
itself, cut out of those of all (`stacked_results`). Blocks are those of the numbers of the points, so that a point has
the same value to the last digit whichever others are asked for with it. A variant that is not clear (see
`linkage.stacked`) is solved alone, and so is one that fails. Of one and the same variant solved alone and together
values agree up to rounding; its errors do not: reductions that are solved together tell a bound, one that is solved
alone tells what it has measured, which is less, and power and motion take it over.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from tmmcalc.batch.points import solve_points as solve_alone
from tmmcalc.batch.preparing import prepared
from tmmcalc.batch.stacked_columns import Columns
from tmmcalc.batch.stacked_inputs import Together
from tmmcalc.batch.stacked_results import Results
from tmmcalc.batch.task import Row, Task

SOLVER = "tmmcalc.batch.stacked:solve_points"
FEW = 16  # points that are not worth it
UNLIKE = "near to a limit position, without a solution, or otherwise unlike the rest"


def together(task: Task) -> int:
    """How many points of a task are to be solved together; 0 where they cannot be, or are a few."""
    made = prepared(task) if task.count >= FEW else ""
    return 0 if isinstance(made, str) else made.block


def way(task: Task, apart: Sequence[str] = ()) -> str:
    """How the points of a task are solved, in words; nothing of a few points.

    ``apart`` has the reason of each that was solved alone after all; of several but `UNLIKE` the first is told.
    """
    if task.count < FEW:
        return ""
    made = prepared(task)
    if isinstance(made, str):
        return f"variants solved one by one: {made}"
    said = "variants solved together"
    if made.alone:
        said += f", {', '.join(made.alone)} of each by itself"
    others = [reason for reason in apart if reason != UNLIKE]
    if len(others) < len(apart):
        said += f"; {len(apart) - len(others)} of {task.count} alone, {UNLIKE}"
    return f"{said}; {len(others)} of {task.count} alone: {others[0]}" if others else said


def solve_points(task: Task, points: Sequence[int]) -> list[Row]:
    """Rows of the points, in their order; those that cannot be solved together are solved alone."""
    made, found, apart = prepared(task), dict[int, Row](), dict[int, str]()
    if not isinstance(made, str):
        for number in dict.fromkeys(point // made.block for point in points):
            block = range(number * made.block, min((number + 1) * made.block, task.count))
            rows = _rows(made, block, tuple(map(task.values, block)))
            found.update((row.point, row) for row in rows.found.values())
            apart.update((block[k], reason) for k, reason in rows.apart.items())
    rest = [point for point in points if point not in found]
    found.update((row.point, replace(row, alone=apart.get(row.point, UNLIKE))) for row in solve_alone(task, rest))
    return [found[point] for point in points]


@lru_cache(maxsize=4)  # neighbouring blocks, when points are asked for one by one
def _rows(made: Columns | Results, points: range, values: tuple[tuple[float, ...], ...]) -> Together[Row]:
    return made.rows(points, np.array(values))
