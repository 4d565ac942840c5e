"""How large the numbers of a spec are, against which steps of each are small, and which of them take any step."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.batch.task import Task
from tmmcalc.core.errors import SpecError, TmmError
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.units import parse as in_si
from tmmcalc.spec.variants import Axis

SMALL = 1e-3  # of the largest of its kind: a number that is smaller is changed as if it were that large
NOTHING = 0.1  # of the largest of its kind: as if it were that large a number that is 0 is changed


def scales(axes: Sequence[Axis]) -> list[float]:
    """An ordinary size of each value, in its unit: its own, or of one near 0 a part of the largest of its kind."""
    largest: dict[str, float] = {}
    sizes = [_in_si(axis) for axis in axes]
    for kind, unit, value in sizes:
        largest[kind] = max(largest.get(kind, 0.0), abs(value) * unit)
    return [max(abs(value), (SMALL if value else NOTHING) * largest[kind] / unit) or 1.0 for kind, unit, value in sizes]


def varied(task: Task, sizes: Sequence[float]) -> list[str]:
    """Why each key of a task of one point cannot be varied, by a small step of its size; empty where it can."""
    variants, values = task.variants(), task.values(0)
    reasons = []
    for k, (axis, size) in enumerate(zip(task.axes, sizes, strict=True)):
        errors = []
        for step in (1e-3 * size, -1e-3 * size):
            try:
                variants.spec([axis.assignment(values[k] + step)])
                break
            except TmmError as error:
                errors.append(error.faults[0].message if isinstance(error, SpecError) else error.message)
        reasons.append(errors[0] if len(errors) == 2 else "")
    return reasons


def _in_si(axis: Axis) -> tuple[str, float, float]:
    """Kind of a quantity, its unit in SI, its value in its unit."""
    unit, value = axis.unit or axis.si, axis.values[0]
    dimension = dimension_of(f"1 {unit}") if unit else None
    if dimension is None:
        return unit, 1.0, value
    return dimension, in_si(f"1 {unit}", dimension), value
