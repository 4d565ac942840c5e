"""Methods of finding a blocking contour: a raster over the plane of the shifts, and borders found as roots.

A raster judges its nodes; a square belongs to the contour if all four of its corners do, so its area is too small by
about the length of the border times half a step: of order 1. Lines of constant sum with their two ends found as roots
are summed by the trapezoid rule. The stage finds corners too and sums smooth pieces between them by Gauss's rule.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.core.studies.measure import Way, by_quantity, relative
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.gears.involute.contour.bounds import cuts
from tmmcalc.gears.involute.contour.contour import Contour, contour
from tmmcalc.gears.involute.contour.frame import frame_of
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.contour.points import largest_sum
from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.contour.trace import scan
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.model import Values

GRIDS = (20, 40, 80, 160, 320)  # nodes along each side
LINES = (16, 32, 64, 128, 256, 512)
EDGES = (4, 6, 8, 12, 24)  # points of an edge; 24 are the stage's
FINER, FINEST = 48, 64
# of area and largest sum
ORDERS: dict[str, tuple[float | None, float | None]] = {"raster": (1.0, None), "lines of constant sum": (None, 1.0)}


@record
class _Found:
    """What a method tells of a contour."""

    area: float
    total: float  # largest x1 + x2, point C


def studies(scene: Scene) -> Iterator[Study]:
    """Area and largest sum of shifts of the contour of the first external pair that has one."""
    found = _first(scene)
    if found is None:
        return
    task, fine = found
    assert fine.main is not None
    exact = _of(fine)
    finer = _of(contour(task, fine.strict, pieces=False, points=FINER))
    kind = "strict" if fine.strict else "tolerated"
    quantities = {f"area of the {kind} contour": "area", "largest x1 + x2": "total"}
    every = zip(*_series(scene, _ways(task, fine), exact), strict=True)
    for (quantity, name), found_series in zip(quantities.items(), every, strict=True):
        missed = relative(getattr(finer, name), getattr(exact, name))
        reference = Reference(f"edges between exact corners at {FINEST} Gauss points", missed)
        yield Study("blocking", quantity, reference, found_series)


def _first(scene: Scene) -> tuple[Task, Contour] | None:
    """The task of a pair, and its contour with fine edges: strict, else tolerated."""
    for pair in scene.results["pair"].pairs:
        if pair.task.kind != "external":
            continue
        task = contour_task(pair.task)
        for strict in (True, False):
            fine = contour(task, strict, pieces=False, points=FINEST)
            if fine.main is not None:
                return task, fine
    return None


def _series(scene: Scene, ways: dict[str, list[Way]], exact: _Found) -> Iterator[tuple[Series, ...]]:
    errors = (
        lambda found: relative(found.area, exact.area),
        lambda found: relative(found.total, exact.total),
    )
    for method, each in ways.items():
        yield by_quantity(method, each, errors, scene.clock, expected=ORDERS.get(method, (None, None)))


def _ways(task: Task, fine: Contour) -> dict[str, list[Way]]:
    window = _window(fine)
    return {
        "raster": [Way(f"{n} x {n}", 1 / n, partial(_raster, task, fine.strict, window, n)) for n in GRIDS],
        "lines of constant sum": [Way(f"{n} lines", 1 / n, partial(_lines, fine, n)) for n in LINES],
        "edges between corners": [Way(f"{n} points", None, partial(_outlined, task, fine.strict, n)) for n in EDGES],
    }


def _outlined(task: Task, strict: bool, points: int) -> _Found:
    return _of(contour(task, strict, pieces=False, points=points))


def _of(found: Contour) -> _Found:
    return _Found(found.region.area, float(sum(largest_sum(found))))


def _window(fine: Contour) -> Values:
    """Least and largest x1 and x2 (2, 2) of the contour."""
    edges = np.array(fine.region.outline)
    return np.stack((edges.min(axis=1), edges.max(axis=1)), axis=1)


def _raster(task: Task, strict: bool, window: Values, nodes: int) -> _Found:
    # the outermost nodes stand half a step off, so that borders along the axes are always missed by as much
    x1, x2 = (low + (np.arange(nodes) - 0.5) * (high - low) / (nodes - 2) for low, high in window)
    one, two = np.meshgrid(x1, x2, indexing="ij")
    held = (margins(task, one, two).least(strict) >= 0) & _central(task, one, two)
    whole = held[1:, 1:] & held[:-1, 1:] & held[1:, :-1] & held[:-1, :-1]
    step = (x1[1] - x1[0]) * (x2[1] - x2[0])
    return _Found(float(whole.sum() * step), float(np.max((one + two)[held], initial=0.0)))


def _central(task: Task, x1: Values, x2: Values) -> NDArray[np.bool_]:
    """Whether both tips lie outside the reference circles, as in the main region where no neck joins others to it."""
    if frame_of(task).neck > 0:
        return np.ones(x1.shape, bool)
    pair = pair_of_shifts(replace(task.first, shift=x1), replace(task.second, shift=x2))
    tips = zip(pair.tips, pair.wheels, strict=True)
    outside: NDArray[np.bool_] = np.logical_and.reduce([np.asarray(tip) >= wheel.reference for tip, wheel in tips])
    return outside


def _lines(fine: Contour, count: int) -> _Found:
    """Lines of equal steps of the operating angle over all that have a contact ratio at all."""
    frame = fine.frame
    w = scan(frame, 0)
    found = cuts(frame, np.linspace(w[0], w[-1], count + 1), 0, tolerated=not fine.strict)
    low, high, _, _ = found.ends(fine.strict)
    width = np.maximum(high - low, 0.0)
    total = found.sums.total
    if not width.any():
        raise NoSolutionError("no line meets the contour", where="blocking", remedy="more lines")
    return _Found(float(np.trapezoid(width, total)), float(total[np.flatnonzero(width > 0)[-1]]))
