"""From the table ``[indexing]`` to what is asked of an indexing drive."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from tmmcalc.cams.indexing.laws import StepLaw, constant_ends, step_law, stepping
from tmmcalc.cams.indexing.task import FRICTION_RATIO, IndexingTask
from tmmcalc.cams.tables.tasks.own_law import to_law
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.tables.indexing_law import StepLawTable


def to_indexing(spec: CamTables) -> IndexingTask:
    """The indexing drive of the spec; raises `UsageError` if it has none, or a law that cannot move a wheel."""
    table = spec.indexing
    if table is None:
        remedy = "add [indexing] with rollers, step_angle, law and wheel_radius"
        raise UsageError("the spec has no [indexing]", remedy=remedy)
    ratio = table.ratio if table.centre_distance is None else table.centre_distance / table.wheel_radius
    first, second = (table.roller_radius, None) if table.roller_radii is None else table.roller_radii
    return IndexingTask(
        law=to_step_law(table.law),
        rollers=table.rollers,
        step=table.step_angle,
        wheel=table.wheel_radius,
        ratio=ratio,
        roller=first,
        second_roller=second,
        dwells=None if table.dwells is None else (table.dwells[0], 2 * pi - 2 * table.step_angle - table.dwells[0]),
        limit=table.pressure_angle,
        friction=table.friction,
        pin_friction=FRICTION_RATIO * table.friction if table.pin_friction is None else table.pin_friction,
        shaft=table.shaft_radius,
        rows=table.steps,
        tolerance=table.tolerance,
    )


def to_step_law(law: str | StepLawTable) -> StepLaw:
    """The law by its name, its code or its table; raises `UsageError` if it cannot move a wheel step by step.

    >>> to_step_law("0010").name
    '0010'
    """
    if isinstance(law, str):
        return step_law(law)
    if law.peak_velocity is not None:
        return StepLaw(f"known by B = {law.peak_velocity:g} alone", law.peak_velocity)
    return stepping(to_law(law) if law.constant_ends is None else constant_ends(law.constant_ends))
