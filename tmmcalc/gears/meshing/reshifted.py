"""Pairs whose wheels are cut with other shifts than they were found with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair


def with_shifts(found: Pairs, shifts: Sequence[tuple[float, float]]) -> Pairs:
    """The same pairs with these shifts, whether they are admissible or not; raises `NoSolutionError` for no mesh."""
    tasks = (replace(pair.task, strategy="given", refuse=False) for pair in found.pairs)
    pairs = (solve_pair(replace(task, shifts=own)) for task, own in zip(tasks, shifts, strict=True))
    return replace(found, pairs=tuple(pairs))
