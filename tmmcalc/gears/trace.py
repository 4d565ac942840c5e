"""Which of the tooth sets the textbook's programs would find, without stepping through them.

For given e and Z2' the programs keep the greatest Z2 that the ratio admits (4.17): with one tooth more on wheel 2 and
one less on wheel 1 the ratio would be beyond its upper limit. Neighbours that overlap end the inner loop only where all
further sets overlap too, so nothing else is passed over but the e below and above the textbook's bounds.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np

from tmmcalc.gears.bounds import side, step_bounds
from tmmcalc.gears.exact import within
from tmmcalc.gears.model import Interval, ToothSets, TrainTask
from tmmcalc.gears.stepping import PROGRAMS, stepped


def found_by_textbook(task: TrainTask, sets: ToothSets) -> np.ndarray | None:
    """Whether the textbook's program for the layout finds each set (n,); None where it has none for the task."""
    if task.layout not in PROGRAMS or task.demands.largest_angle is not None:
        return None
    if task.layout == "AIbar":
        return np.ones(len(sets), dtype=bool)
    if not task.scheme.branched:
        rows = {tuple(row) for row in stepped(task).sets.teeth.tolist()}
        return np.array([tuple(row) in rows for row in sets.teeth.tolist()], dtype=bool)
    found = np.zeros(len(sets), dtype=bool)
    for proportion in task.proportions:
        at = np.flatnonzero((sets.modules == proportion).all(axis=1))
        if len(at):
            part = replace(sets, teeth=sets.teeth[at], modules=sets.modules[at], angles=sets.angles[at])
            found[at] = _stepped(task, (proportion[0], proportion[1]), part)
    return found


def _stepped(task: TrainTask, proportion: tuple[int, int], sets: ToothSets) -> np.ndarray:
    """The same for coaxial, AA and AI with one proportion of modules."""
    e = (sets.of("1") + sets.of("2")) // proportion[1]
    first, last = _steps(task, proportion)
    sun, wheel = sets.of("1") - 1, sets.of("2") + 1
    above = wheel * sets.of("3"), np.maximum(sun, 1) * sets.of("2'")
    admitted = within(Interval(Fraction(0), task.ratio.high), *above, int(above[1].max(initial=1)))
    found: np.ndarray = (e >= first) & (e <= last) & (~admitted | (sun < 1))
    return found


def _steps(task: TrainTask, proportion: tuple[int, int]) -> tuple[int, int]:
    """The first and the last e of the programs 1.9 and 2.4."""
    bounds = step_bounds(task, proportion)
    first = math.ceil(bounds.teeth.root)
    if bounds.neighbours_book is not None:
        first = math.floor(max(bounds.teeth.root, bounds.neighbours_book.root)) + 1
    return first, math.floor(bounds.largest if side(task) > 0 else 2 * task.limits.largest / proportion[0])
