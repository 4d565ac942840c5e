"""Methods of synthesis of tooth numbers: the textbook's stepping through z or e, and the complete search.

Ratios are exact fractions, so no set is in error; a method that passes sets over misses the best ratio. The error is
the least deviation from the ratio asked for among the sets of the method, above the least of all sets there are. A
coarser setting admits fewer teeth. The count beside the time is that of the sets found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.stepping import PROGRAMS
from tmmcalc.gears.train import programmed
from tmmcalc.gears.trains import Request

PARTS = (0.4, 0.6, 0.8, 1.0)  # of the largest number of teeth


def studies(scene: Scene) -> Iterator[Study]:
    """The ratio of every layout that has tooth sets at all."""
    for asked in scene.inputs.requests:
        request = replace(asked, task=replace(asked.task, teeth=None))  # of given ones there is nothing to seek
        best = _deviation(request, _complete(request))
        if best is None:
            continue
        yield Study(
            "train",
            f"ratio of {request.title}",
            Reference("the complete search itself, in exact fractions", 0.0),
            tuple(_series(scene, request, best)),
        )


def _series(scene: Scene, request: Request, best: float) -> Iterator[Series]:
    methods: dict[str, Callable[[Request], ToothSets]] = {"complete search": _complete}
    if request.scheme.key in PROGRAMS:
        methods["textbook's stepping"] = lambda asked: programmed(asked).sets
    for name, method in methods.items():

        def error(found: ToothSets) -> float:
            deviation = _deviation(request, found)
            assert deviation is not None  # _found refuses an empty list
            return relative(deviation, best, 1.0)

        yield series(name, _ways(request, method), error, scene.clock)


def _ways(request: Request, method: Callable[[Request], ToothSets]) -> Iterator[Way]:
    limits = request.task.limits
    for part in PARTS:
        largest, ring = (max(round(part * n), 1) for n in (limits.largest, limits.largest_ring))
        if largest < limits.least or ring < limits.least_ring:
            continue
        smaller = replace(limits, largest=largest, largest_ring=ring)
        asked = replace(request, task=replace(request.task, limits=smaller))
        yield Way(f"z to {largest}", None, partial(_found, method, asked), len)


def _found(method: Callable[[Request], ToothSets], asked: Request) -> ToothSets:
    """The sets; raises `NoSolutionError` if there are none."""
    found = method(asked)
    if not len(found):
        raise NoSolutionError("no tooth set", where="train", remedy="more teeth")
    return found


def _complete(request: Request) -> ToothSets:
    return synthesise(request.task, request.keep).sets


def _deviation(request: Request, sets: ToothSets) -> float | None:
    """The least relative deviation of the ratio asked for; None without sets."""
    return float(np.min(np.abs(ratios(request, sets)[1]))) if len(sets) else None
