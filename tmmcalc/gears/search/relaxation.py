"""Why a task has no solution: which single constraint stands in the way, and the least change that opens it.

Each constraint that binds is dropped alone. If sets appear, the one that breaks it least tells the value that the
constraint would have to have. Limits of teeth are widened until sets appear, and then bisected; the tolerance of the
ratio likewise, up to the nearest ratio that the other constraints admit.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tmmcalc.gears.model import Interval, ToothSets, TrainTask
from tmmcalc.gears.search import measures
from tmmcalc.gears.search.constraints import CONSTRAINTS
from tmmcalc.gears.search.measures import Measure
from tmmcalc.gears.search.search import synthesise
from tmmcalc.records import record

MOST_TEETH, FEWEST_TEETH = 1000, 6  # beyond them wheels are not proposed
STEEPEST_MESH = math.radians(44)  # hard limit of operating pressure angles (13.4)
MOST_PLANETS = 12


@record
class Relaxation:
    """A change of one constraint that opens the task."""

    constraint: str
    present: float  # value of its limit
    needed: float  # value that it would have to have
    teeth: tuple[int, ...]  # the first set that then appears


def relaxations(task: TrainTask) -> tuple[Relaxation, ...]:
    """Changes of single constraints, each of which gives at least one set; empty: no single one does."""
    found = [_ratio(task), *_teeth(task), _planets(task), *_dropped(task), _angles(task)]
    return tuple(change for change in found if change is not None)


def _ratio(task: TrainTask) -> Relaxation | None:
    """The nearest ratio that everything else admits."""
    width = max(task.ratio.high - task.ratio.low, abs(task.nominal) / 10**6)
    while width <= 2 * abs(task.nominal):
        width *= 4
        low, high = task.nominal - width / 2, task.nominal + width / 2
        floor = abs(task.nominal) / 1000  # ratios keep their sign
        interval = Interval(max(low, floor), high) if task.nominal > 0 else Interval(low, min(high, -floor))
        sets = synthesise(replace(task, ratio=interval)).sets
        if len(sets):
            errors = abs(measures.ratio_error(task, sets))
            best = int(np.argmin(errors))
            present = float(max(task.ratio.high - task.nominal, task.nominal - task.ratio.low) / abs(task.nominal))
            return Relaxation("ratio", present, float(errors[best]), _row(sets, best))
    return None


def _teeth(task: TrainTask) -> list[Relaxation | None]:
    """Wider limits of the numbers of teeth, one at a time."""
    limits = task.limits
    found = [
        _widened(task, "largest", limits.largest, MOST_TEETH),
        _widened(task, "least", limits.least, FEWEST_TEETH),
    ]
    if task.scheme.rings:
        found.append(_widened(task, "largest_ring", limits.largest_ring, 2 * MOST_TEETH))
        found.append(_widened(task, "least_ring", limits.least_ring, FEWEST_TEETH))
    if not task.scheme.branched:
        found.append(_widened(task, "largest_pinion", limits.largest_pinion, limits.largest))
    if limits.largest_sum is not None:
        found.append(_widened(task, "largest_sum", limits.largest_sum, 2 * MOST_TEETH))
    return found


def _widened(task: TrainTask, name: str, present: int, extreme: int) -> Relaxation | None:
    """The limit nearest to the present one that gives a set, by doubling and bisection: more room, more sets."""

    def sets_at(limit: int) -> ToothSets:
        return synthesise(replace(task, limits=replace(task.limits, **{name: limit})), keep=1).sets

    outward = 1 if extreme > present else -1
    closed, step = present, max(abs(present) // 8, 1)
    while True:
        opened = closed + outward * step
        opened = min(opened, extreme) if outward > 0 else max(opened, extreme)
        if opened == closed:
            return None
        if len(sets_at(opened)):
            break
        closed, step = opened, 2 * step
    while abs(opened - closed) > 1:
        middle = (opened + closed) // 2
        opened, closed = (middle, closed) if len(sets_at(middle)) else (opened, middle)
    return Relaxation(name, float(present), float(opened), _row(sets_at(opened), 0))


def _planets(task: TrainTask) -> Relaxation | None:
    """The nearest other number of planets that gives a set."""
    if not task.scheme.branched or task.planets == 1:
        return None
    others = sorted(range(1, MOST_PLANETS + 1), key=lambda k: (abs(k - task.planets), k))
    for other in others[1:]:
        sets = synthesise(replace(task, planets=other), keep=1).sets
        if len(sets):
            return Relaxation("planets", float(task.planets), float(other), _row(sets, 0))
    return None


# constraint: (the task without it, what it limits, whether the largest value is the nearest, its present limit)
_Drop = tuple[dict[str, object], Measure, bool, Callable[[TrainTask], float]]
_DROPPED: dict[str, _Drop] = {
    "adjacency": ({"gap": None}, measures.room, True, lambda t: float(t.demands.gap or 0)),
    "interference": (
        {"ring_difference": None},
        measures.ring_difference,
        True,
        lambda t: float(t.demands.ring_difference or 0),
    ),
    "undercut": ({"undercut": None}, measures.least_external, True, lambda t: float(t.demands.undercut or 0)),
    "stage_ratio": ({"stage_ratio": None}, measures.steepest, False, lambda t: float(t.demands.stage_ratio or 0)),
    "diameter_band": (
        {"diameter_band": None},
        measures.unlikeness,
        False,
        lambda t: float(t.demands.diameter_band or 0),
    ),
    "assembly": ({"assembly": False}, lambda t, s: np.zeros(len(s)), False, lambda t: 1.0),
    "coprime": ({"coprime": False}, lambda t, s: np.zeros(len(s)), False, lambda t: 1.0),
    "equal_pinions": ({"equal_pinions": False}, lambda t, s: np.zeros(len(s)), False, lambda t: 1.0),
    "centre_distance": ({"centre_distance": None}, measures.distance, False, lambda t: 0.0),
    "envelope": ({"envelope": None}, measures.diameter, False, lambda t: float(t.demands.envelope or 0)),
}


def _dropped(task: TrainTask) -> list[Relaxation | None]:
    return [_without(task, name, drop) for name, drop in _DROPPED.items() if _binds(task, name)]


def _binds(task: TrainTask, name: str) -> bool:
    if name == "equal_pinions":
        return task.demands.equal_pinions
    if name in ("stage_ratio", "diameter_band") and not task.scheme.branched:
        return getattr(task.demands, name) is not None
    return CONSTRAINTS[name][0](task)


def _without(task: TrainTask, name: str, drop: _Drop) -> Relaxation | None:
    """The set that breaks this constraint least, if there is one without it."""
    change, measure, up, present = drop
    sets = synthesise(replace(task, demands=replace(task.demands, **change))).sets  # type: ignore[arg-type]
    if not len(sets):
        return None
    values = measure(task, sets)
    if name == "centre_distance":
        low, high = task.demands.centre_distance or (None, None)
        limits = low or 0.0, math.inf if high is None else high
        best = int(np.argmin(np.maximum(limits[0] - values, values - limits[1])))
        passed = limits[0] if values[best] < limits[0] else limits[1]
        return Relaxation(name, passed, float(values[best]), _row(sets, best))
    best = int(np.argmax(values) if up else np.argmin(values))
    needed = float(values[best]) + (present(task) if name == "adjacency" else 0.0)
    if name == "adjacency" and needed < 0:  # the planets would overlap
        return None
    return Relaxation(name, present(task), needed, _row(sets, best))


def _angles(task: TrainTask) -> Relaxation | None:
    """The least operating pressure angle that closes the centre distances."""
    present = task.demands.largest_angle
    if not task.scheme.branched or (present is not None and present >= STEEPEST_MESH):
        return None
    open_task = replace(task, demands=replace(task.demands, largest_angle=STEEPEST_MESH))
    sets = synthesise(open_task).sets
    if not len(sets):
        return None
    values = measures.largest_angle(open_task, sets)
    best = int(np.argmin(values))
    given = task.pressure_angle if present is None else present
    return Relaxation("mesh_angles", given, float(values[best]), _row(sets, best))


def _row(sets: ToothSets, place: int) -> tuple[int, ...]:
    return tuple(int(z) for z in sets.teeth[place])
