"""Why a task has no solution: which single constraint stands in the way, and the least change that opens it.

Each constraint that binds is dropped alone. If sets appear, the one that breaks it least tells the value that the
constraint would have to have. Limits of teeth are widened until sets appear, and then bisected; the tolerance of the
ratio likewise, up to the nearest ratio that the other constraints admit.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.kinds import from_tooth_ratio, to_tooth_ratio
from tmmcalc.gears.model import Interval, ToothSets, TrainTask, Values
from tmmcalc.gears.search import measures
from tmmcalc.gears.search.blocks import Tally
from tmmcalc.gears.search.constraints import CONSTRAINTS, sieve
from tmmcalc.gears.search.measures import Measure
from tmmcalc.gears.search.search import every_set, synthesise

MOST_TEETH, FEWEST_TEETH = 400, 6  # beyond them wheels are not proposed
STEEPEST_MESH = math.radians(26)  # operating pressure angles beyond it are not proposed
WORK = 2_000_000  # pairs of sums that are looked at for meshes with raised angles
MOST_PLANETS = 12
FARTHEST = Fraction(10**5)  # parts of the ratio within which the nearest one is looked for
HALVINGS = 8  # of the band in which the nearest ratio lies, before all sets in it are compared


@record
class Relaxation:
    """A change of one constraint that opens the task."""

    constraint: str
    present: float  # value of its limit
    needed: float  # value that it would have to have
    teeth: tuple[int, ...]  # the first set that then appears


def relaxations(task: TrainTask, kind: str = "u") -> tuple[Relaxation, ...]:
    """Changes of single constraints, each of which gives at least one set; empty: no single one does.

    ``kind`` is the kind of ratio (see `tmmcalc.gears.kinds`) in which the nearest ratios are looked for, the one below
    and the one above the asked ratio, as far as there are any.
    """
    nearest = [nearest_ratio(task, kind, outward) for outward in (False, True)]
    found = [*sorted((c for c in nearest if c), key=lambda c: c.needed), *_teeth(task), _planets(task), *_dropped(task)]
    return tuple(change for change in (*found, _angles(task)) if change is not None)


def nearest_ratio(task: TrainTask, kind: str, outward: bool) -> Relaxation | None:
    """The nearest ratio towards zero or away from it that everything else admits; None: there is none on that side."""
    ratio = from_tooth_ratio(task.scheme, kind, task.nominal)
    if ratio is None:
        return None
    opened = FARTHEST
    if not _any(_beside(task, kind, ratio, outward, opened)):
        return None
    closed = Fraction(0)
    step = Fraction(1, 10**6)
    while step < opened and not _any(_beside(task, kind, ratio, outward, step)):
        closed, step = step, 4 * step
    opened = min(step, opened)
    for _ in range(HALVINGS):
        middle = (closed + opened) / 2
        if _any(_beside(task, kind, ratio, outward, middle)):
            opened = middle
        else:
            closed = middle
    return _closest(task, kind, ratio, _beside(task, kind, ratio, outward, opened))


def _beside(task: TrainTask, kind: str, ratio: Fraction, outward: bool, part: Fraction) -> TrainTask:
    """The task for ratios from the asked one to one larger or smaller by this part, in the kind of the ratio."""
    far = ratio * (1 + part) if outward else ratio / (1 + part)
    ends = sorted(to_tooth_ratio(task.scheme, kind, end) for end in (ratio, far))
    if task.nominal > 0:
        ends = [max(end, abs(task.nominal) / FARTHEST) for end in ends]
    return replace(task, ratio=Interval(*ends))


def _any(task: TrainTask) -> bool:
    """Whether the task has a set at all."""
    tally = Tally(counts=False)
    blocks = (block for parts in task.proportions for block in task.scheme.candidates(task, parts, tally))
    return any(len(sieve(task, block, tally)) for block in blocks if len(block))


def _closest(task: TrainTask, kind: str, ratio: Fraction, open_task: TrainTask) -> Relaxation | None:
    """Of all sets of the open task the one nearest to the ratio."""
    best: tuple[float, tuple[int, ...]] | None = None
    for sets in every_set(open_task):
        errors = _errors(sets, kind, ratio)
        place = int(np.argmin(errors))
        if best is None or errors[place] < best[0]:
            best = float(errors[place]), _row(sets, place)
    if best is None:
        return None
    admitted = (from_tooth_ratio(task.scheme, kind, end) for end in (task.ratio.low, task.ratio.high))
    present = max((abs(float(end / ratio - 1)) for end in admitted if end is not None), default=0.0)
    return Relaxation("ratio", present, best[0], best[1])


def _errors(sets: ToothSets, kind: str, ratio: Fraction) -> Values:
    """Relative deviation (n,) of the ratio of this kind; of a wheel 1 that stands still without end."""
    numerator, denominator = (part.astype(float) for part in measures.tooth_ratio(sets))
    if kind in ("i_1H", "i_H1"):
        numerator, denominator = denominator + sets.scheme.sign * numerator, denominator
    if kind == "i_H1":
        numerator, denominator = denominator, numerator
    with np.errstate(divide="ignore"):
        deviation: Values = abs(numerator / denominator / float(ratio) - 1)
    return deviation


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

    def at(limit: int) -> TrainTask:
        return replace(task, limits=replace(task.limits, **{name: limit}))

    outward = 1 if extreme > present else -1
    closed, step = present, max(abs(present) // 8, 1)
    while True:
        opened = closed + outward * step
        opened = min(opened, extreme) if outward > 0 else max(opened, extreme)
        if opened == closed:
            return None
        if _any(at(opened)):
            break
        closed, step = opened, 2 * step
    while abs(opened - closed) > 1:
        middle = (opened + closed) // 2
        opened, closed = (middle, closed) if _any(at(middle)) else (opened, middle)
    return Relaxation(name, float(present), float(opened), _row(synthesise(at(opened), keep=1).sets, 0))


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
_Drop = tuple[dict[str, Any], Measure, bool, Callable[[TrainTask], float]]
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
    sets = synthesise(replace(task, demands=replace(task.demands, **change))).sets
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
    open_task = replace(task, proportions=_simplest(task), demands=replace(task.demands, largest_angle=STEEPEST_MESH))
    sets = synthesise(open_task).sets
    if not len(sets):
        return None
    values = measures.largest_angle(open_task, sets)
    best = int(np.argmin(values))
    given = task.pressure_angle if present is None else present
    return Relaxation("mesh_angles", given, float(values[best]), _row(sets, best))


def _simplest(task: TrainTask) -> tuple[tuple[int, ...], ...]:
    """The simplest proportions of the modules, so many as a hint may cost: some ten sums a pair may close a stage."""
    sums = 2 if task.scheme.three_centrals else 1
    each = (task.limits.largest - task.limits.least + 1) ** 2 * 10**sums
    return tuple(sorted(task.proportions, key=sum)[: max(WORK // max(each, 1), 1)])


def _row(sets: ToothSets, place: int) -> tuple[int, ...]:
    return tuple(int(z) for z in sets.teeth[place])
