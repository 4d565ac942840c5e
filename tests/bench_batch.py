"""The part of ``make bench`` about sweeps: variants solved together and one by one, in one and two processes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray
from timing import bar_text

import tmmcalc
from tmmcalc.batch import executors, points, stacked
from tmmcalc.batch.local import available, processes
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.stacked_columns import BLOCK
from tmmcalc.batch.task import Task

SHAPER = Path(tmmcalc.__file__).parents[1] / "configs" / "shaper.toml"
COUNT = 10_000
ALONE = 8  # points that are solved one by one too
FACTS = 256  # points of which all facts are asked for
MOST = 1000.0  # microseconds a variant, together
COLUMNS = ("kinematics.max(v_D0)", "forces.max(R_A)", "forces.size(M_drive)", "motion.max(omega)", "motion.min(omega)")


def task() -> Task:
    """A hundred cranks times a hundred rams of the shaper, at 72 positions."""
    ranges = ("mechanism.links[id=1].points.A[0]=*0.9:1.1:100", "mechanism.links[id=5].mass=*0.8:1.2:100")
    return task_of(SHAPER, [*ranges, "mechanism.grid.positions=72"], None, (), COLUMNS)


def batches() -> list[str]:
    """Ten thousand shapers: kinematics, forces and motion; bars are of processor time, which no neighbour takes."""
    asked = task()
    blocks = [list(block) for _, block in groupby(range(COUNT), lambda point: point // BLOCK)]
    print(f"\n{COUNT} shapers, kinematics, forces and motion at 72 positions     a variant   processor")
    alone = _seconds(lambda: points.solve_points(asked, range(0, COUNT, COUNT // ALONE))) / ALONE
    _line("one by one", alone)
    made = stacked.prepared(asked)
    assert not isinstance(made, str)
    made.rows(range(1), values(asked, range(1)))
    one = _seconds(lambda: [stacked.solve_points(asked, block) for block in blocks]) / COUNT
    _line(f"together, {BLOCK} at a time", one, bar_text(one[1] * 1e6, MOST))
    print(f"    times as fast as one by one {alone[0] / one[0]:42.1f} {alone[1] / one[1]:11.1f}")
    if available():
        of_blocks = replace(asked, solver=stacked.SOLVER, block=BLOCK)
        two = _two(of_blocks, blocks)
        print(f"  together, in two processes, from their first rows on {two * 1e6:17.0f} us")
        print(f"    times as fast as in one {one[0] / two:46.2f}")
    _all_facts()
    return ["sweep of the shaper"] if one[1] * 1e6 > MOST else []


def values(task: Task, some: range) -> Any:
    """Values (v, axes) of some points."""
    return np.array([task.values(point) for point in some])


def _all_facts() -> None:
    """The same shapers, of which all facts up to the motion are asked for."""
    asked = replace(task(), targets=("forces", "motion"), patterns=())
    alone = _seconds(lambda: points.solve_points(asked, range(0, COUNT, COUNT // ALONE))) / ALONE
    _line("all their facts, one by one", alone)
    made = stacked.prepared(asked)
    assert not isinstance(made, str)
    assert len(made.rows(range(8), values(asked, range(8))).found) == 8
    parts = [range(at, at + made.block) for at in range(0, FACTS, made.block)]
    both = _seconds(lambda: [made.rows(part, values(asked, part)) for part in parts]) / FACTS
    _line("together", both)
    print(f"    times as fast as one by one {alone[0] / both[0]:42.1f} {alone[1] / both[1]:11.1f}")


def _two(task: Task, blocks: list[list[int]]) -> float:
    """Seconds a variant in two processes, without the time that they take to start."""
    arrived = []
    for rows in executors.solve_by(processes(2), task, blocks, print):
        arrived.append((perf_counter(), len(rows)))
    return (arrived[-1][0] - arrived[0][0]) / sum(count for _, count in arrived[1:])


def _line(name: str, seconds: NDArray[np.float64], bar: str = "") -> None:
    print(f"  {name:<57} {seconds[0] * 1e6:10.0f} us {seconds[1] * 1e6:8.0f} us  {bar}")


def _seconds(work: Callable[[], object]) -> NDArray[np.float64]:
    """Seconds on the clock, and those that the processor worked for this process."""
    began = perf_counter(), process_time()
    work()
    return np.array([perf_counter() - began[0], process_time() - began[1]])


if __name__ == "__main__":
    batches()
