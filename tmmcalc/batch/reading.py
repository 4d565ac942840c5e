"""The task of a sweep from what a user gives: a spec, ranges and overrides, or a table of points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.batch.table import read_points
from tmmcalc.batch.task import Task
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.plan import known_stage
from tmmcalc.naming.language import stages_of
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.rooms import STAGES
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.override import split
from tmmcalc.spec.variants import MOST, Axis, axis, given, is_range

if TYPE_CHECKING:
    from tmmcalc.project import Spec

_REMEDY = "give a range, e.g. --set 'mechanism.links[id=1].points.A[0]=*0.9:1.1:21'"


def task_of(
    file: Path,
    sets: Sequence[str],
    points: Path | None,
    targets: Sequence[str],
    patterns: Sequence[str],
    tolerance: float | None = None,
) -> Task:
    """The task; raises UsageError, or SpecError for a file that is no TOML."""
    for target in targets:
        known_stage(target, STAGES)
    ranged = [each for each in sets if is_range(each)]
    fixed = [each for each in sets if each not in ranged]
    text = read_text(file)
    data = Variants(text, str(file), file.parent, fixed).data
    labels, axes = read_points(points) if points is not None else ((), tuple(axis(each, data) for each in ranged))
    _check(axes, ranged, fixed, points)
    stages = tuple(name for name in STAGES if name in targets) or stages_of(patterns, STAGES)
    task = Task(
        text=text,
        file=str(file),
        folder=str(file.parent.absolute()),  # workers may stand elsewhere
        fixed=tuple(fixed),
        axes=axes,
        listed=points is not None,
        targets=stages,
        patterns=tuple(patterns),
        labels=labels,
        tolerance=tolerance,
    )
    if task.count > MOST:
        raise UsageError(
            f"{task.count} points are more than {MOST}", value=task.count, limit=MOST, remedy="make the ranges coarser"
        )
    return replace(task, axes=_with_units(task))


def frame_of(
    file: Path,
    fixed: Sequence[str],
    keys: Sequence[str],
    patterns: Sequence[str],
    tolerance: float | None = None,
) -> Task:
    """A task of one point, the spec with its overrides as it stands; the axes are keys of it with their values.

    Raises UsageError for a key that holds no number, and SpecError for a spec that has faults.
    """
    text = read_text(file)
    variants = Variants(text, str(file), file.parent, fixed)
    variants.spec()
    axes = tuple(Axis(key, (value,), unit) for key in keys for value, unit in [given(key, variants.data)])
    task = Task(
        text=text,
        file=str(file),
        folder=str(file.parent.absolute()),
        fixed=tuple(fixed),
        axes=axes,
        listed=True,
        targets=stages_of(patterns, STAGES),
        patterns=tuple(patterns),
        tolerance=tolerance,
    )
    return replace(task, axes=_with_units(task, stands=True))


def _with_units(task: Task, *, stands: bool = False) -> tuple[Axis, ...]:
    """The axes of bare numbers with their SI units: the one that, written out, gives the same spec.

    ``stands``: the values are those of the spec, so that none of them needs to be set.
    """
    variants = task.variants()
    point = next((point for point in task.spread() if _spec(variants, task.assignments(point)) is not None), None)
    if point is None or all(axis.unit for axis in task.axes):
        return task.axes
    given = [] if stands else task.assignments(point)
    wanted = _spec(variants, given)
    found = []
    for at, (each, value) in enumerate(zip(task.axes, task.values(point), strict=True)):
        others = [*given[:at], *given[at + 1 :]]
        told = (replace(each, unit=dimension.si) for dimension in DIMENSIONS.values() if not each.unit)
        same = [one.unit for one in told if _spec(variants, [*others, one.assignment(value)]) == wanted]
        found.append(replace(each, si=same[0]) if len(same) == 1 else each)
    return tuple(found)


def _spec(variants: Variants, assignments: Sequence[str]) -> Spec | None:
    """The variant, None if it is no valid spec."""
    try:
        return variants.spec(assignments)
    except TmmError:
        return None


def _check(axes: Sequence[Axis], ranged: Sequence[str], fixed: Sequence[str], points: Path | None) -> None:
    """Refuse what does not vary, and what is said twice."""
    if points is not None and ranged:
        raise UsageError(
            "the points are those of the table", where=f"--set {ranged[0]}", remedy="leave one of them out"
        )
    if not axes:
        raise UsageError("no range is given: nothing would vary", where="--set", remedy=_REMEDY)
    keys = [axis.key for axis in axes] + [split(each)[0] for each in fixed]
    twice = next((key for at, key in enumerate(keys) if key in keys[:at]), None)
    if twice is not None:
        raise UsageError(f"{twice} is set twice", where="--set", remedy="leave one of them out")
