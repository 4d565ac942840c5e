"""The search itself: candidates, sieve, and a bounded list of the smallest trains with the exact count of all."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import apart, spread
from tmmcalc.core.records import record
from tmmcalc.gears.model import ToothSets, TrainTask
from tmmcalc.gears.search.blocks import Block, Tally
from tmmcalc.gears.search.constraints import sieve, stretches

CHOSEN = 12  # sets of each kind whose angles are found again
KEPT = 100_000  # trains that a result holds unless another number is asked for

Progress = Callable[[float, int], None]  # part of the search that is done, trains found


@record
class Synthesis:
    """All tooth sets of a task, or the smallest of them, and what each constraint removed."""

    sets: ToothSets  # by Z1 + Z2, then by tooth numbers
    count: int  # of all sets, also of those that are not held
    candidates: int  # combinations of wheels within the tooth limits
    removed: dict[str, int]  # by constraint, in the order in which they were put

    @property
    def complete(self) -> bool:
        """Whether the result holds every set."""
        return len(self.sets) == self.count


def synthesise(task: TrainTask, keep: int = KEPT, progress: Progress | None = None) -> Synthesis:
    """Every tooth set of the task; at most ``keep`` of them are held, those with the least Z1 + Z2.

    The search is complete: each combination within the tooth limits is either among the sets or counted under the
    first constraint that it breaks. Of a task with given teeth these are the only candidate.
    """
    tally, held, count = Tally(), _Held(keep), 0
    candidates = task.scheme.candidates
    if task.teeth is not None:
        from tmmcalc.gears.search.given import given_candidates as candidates  # late: most tasks give none
    for done, proportion in enumerate(task.proportions, 1):
        for block in candidates(task, proportion, tally):
            found = sieve(task, block, tally)
            if not len(found):
                continue
            count += len(found)
            held.add(_rows(task, found))
            if progress is not None:
                progress(done / len(task.proportions), count)
    removed = {name: number for name, number in tally.removed.items() if number}
    return Synthesis(_sets(task, held.rows()), count, tally.candidates, removed)


def every_set(task: TrainTask) -> Iterator[ToothSets]:
    """All tooth sets of the task block by block, in no order: for what needs to see each of them once."""
    tally = Tally(counts=False)
    for proportion in task.proportions:
        for block in task.scheme.candidates(task, proportion, tally):
            found = sieve(task, block, tally)
            if len(found):
                yield _sets(task, _rows(task, found))


def _rows(task: TrainTask, block: Block) -> np.ndarray:
    """Tooth numbers and proportion of a block as rows of int64."""
    wheels = [block[wheel] for wheel in task.scheme.wheels]
    parts = block.proportion or (0,) * task.scheme.stages
    return np.stack([*wheels, *(np.full(len(block), part) for part in parts)], axis=1)


class _Held:
    """The first ``keep`` rows by Z1 + Z2, then by tooth numbers and proportion; twice as many are in memory at most."""

    def __init__(self, keep: int) -> None:
        self.keep = keep
        self._parts: list[np.ndarray] = []
        self._number = 0
        self._largest: int | None = None  # Z1 + Z2 beyond which no row can be among the first

    def add(self, rows: np.ndarray) -> None:
        """Further rows."""
        if self._largest is not None:
            rows = rows[rows[:, 0] + rows[:, 1] <= self._largest]
        self._parts.append(rows)
        self._number += len(rows)
        if self._number > 2 * self.keep + 1000:
            first = self._first()
            self._parts, self._number = [first], len(first)
            self._largest = int(first[-1, 0] + first[-1, 1]) if len(first) else -1

    def rows(self) -> np.ndarray | None:
        """The rows in order, None without any."""
        return self._first() if self._parts else None

    def _first(self) -> np.ndarray:
        rows = np.concatenate(self._parts)
        keys = (*(rows[:, k] for k in reversed(range(rows.shape[1]))), rows[:, 0] + rows[:, 1])
        ordered: np.ndarray = rows[np.lexsort(keys)[: self.keep]]
        return ordered


def _sets(task: TrainTask, rows: np.ndarray | None) -> ToothSets:
    scheme = task.scheme
    if rows is None:
        rows = np.zeros((0, len(scheme.wheels) + scheme.stages), dtype=np.int64)
    teeth, modules = rows[:, : len(scheme.wheels)], rows[:, len(scheme.wheels) :]
    return ToothSets(task.layout, teeth, modules, _angles(task, teeth, modules), task.planets)


def _angles(task: TrainTask, teeth: np.ndarray, modules: np.ndarray) -> np.ndarray:
    """Operating pressure angles [rad] (n, meshes)."""
    block = Block(
        {wheel: teeth[:, k] for k, wheel in enumerate(task.scheme.wheels)},
        tuple(modules[:, k] for k in range(modules.shape[1])),
    )
    cosines = [math.cos(task.pressure_angle) / stretch for stretch in stretches(task, block)]
    angles = np.stack([np.arccos(np.minimum(cosine, 1.0)) for cosine in cosines], axis=1)
    return np.where(np.isclose(angles, task.pressure_angle, rtol=0, atol=1e-15), task.pressure_angle, angles)


def angle_error(task: TrainTask, sets: ToothSets) -> float:
    """Error of the operating pressure angles relative to the largest, of sets again in extended precision.

    The arc cosine loses digits where an angle is small; the sets of the smallest angles and an even choice of the
    others are taken. 0 where no mesh departs from the angle of the rack.
    """
    shifted = np.flatnonzero((sets.angles != task.pressure_angle).any(axis=1))
    if not len(shifted):
        return 0.0
    smallest = np.argsort(sets.angles[shifted].min(axis=1), kind="stable")[:CHOSEN]
    rows = shifted[sorted({*spread(len(shifted), CHOSEN).tolist(), *smallest.tolist()})]
    teeth, modules = sets.teeth[rows].astype(np.longdouble), sets.modules[rows]
    wheels: Any = {wheel: teeth[:, k] for k, wheel in enumerate(task.scheme.wheels)}
    block = Block(wheels, tuple(modules[:, k] for k in range(modules.shape[1])))
    cosine = np.cos(np.longdouble(task.pressure_angle))
    exact = np.stack([np.arccos(cosine / stretch) for stretch in stretches(task, block)], axis=1)
    return apart(sets.angles[rows], exact)
