"""Variants at places that are chosen while one goes on: samples, steps of differences, generations of a search.

The task is a frame: its spec, keys, what is asked, and a few points that span the box of all places, by which it is
prepared once (`preparing`). What is solved are places: a number and the values of the keys. Executors pass them on as
they pass points.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.batch.points import solve_points as solve_alone
from tmmcalc.batch.preparing import prepared
from tmmcalc.batch.stacked import UNLIKE
from tmmcalc.batch.task import UNSOLVED, Row, Task

SOLVER = "tmmcalc.batch.places:solve_places"
ALIKE = "tmmcalc.batch.places:solve_alike"


class Place(NamedTuple):
    """A variant by its number and the values of the keys."""

    point: int
    values: tuple[float, ...]


def solve_places(task: Task, places: Sequence[Place]) -> list[Row]:
    """Rows of the places, in their order; those that cannot be solved together are solved alone.

    Nothing is raised for a variant: its row says why it failed.
    """
    found, apart = _together(task, places)
    rest = [k for k in range(len(places)) if k not in found]
    if rest:
        alone = task.at([places[k].values for k in rest])
        for k, row in zip(rest, solve_alone(alone, range(len(rest))), strict=True):
            found[k] = replace(row, point=places[k].point, alone=apart.get(k, UNLIKE))
    return [found[k] for k in range(len(places))]


def solve_alike(task: Task, places: Sequence[Place]) -> list[Row]:
    """Rows of those places that can be solved together, the others are left out."""
    found, _ = _together(task, places)
    return [found[k] for k in sorted(found)]


def _together(task: Task, places: Sequence[Place]) -> tuple[dict[int, Row], dict[int, str]]:
    """Rows of places that are solved together, by their order, and why some were not."""
    made, found, apart = prepared(task), dict[int, Row](), dict[int, str]()
    if not isinstance(made, str):
        size = made.block
        for at in range(0, len(places), size):
            block = places[at : at + size]
            rows = made.rows([place.point for place in block], np.array([place.values for place in block]))
            found.update((at + k, row) for k, row in rows.found.items())
            apart.update((at + k, reason) for k, reason in rows.apart.items())
            if task.brief:
                found.update((at + k, Row(block[k].point, UNSOLVED, reason)) for k, reason in rows.refused.items())
    return found, apart
