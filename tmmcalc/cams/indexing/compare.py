"""Numbers of rollers and laws side by side: pressure angles, tips of the lobe and limits of the step at three lambda.

The reference tables of the method are of this kind: one law over z2, all laws at one z2, and the limits of the step.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import degrees
from typing import Any

from tmmcalc.cams.indexing.bounds import TOLERATED, bounds, largest_step, least_step, start_pressure
from tmmcalc.cams.indexing.choice import ROLLERS, most_rollers
from tmmcalc.cams.indexing.handover import Handover, handover
from tmmcalc.cams.indexing.laws import StepLaw, step_law, symmetric_laws
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.records import record

CODES = ("0010",)  # laws of the printed tables beside the catalogue; 0000 is linear, 0050 is const
TABLED = StepLaw("2.9 (its B alone)", 1.625)  # of the printed tables, not identified: poly5 has all its values but one


@record
class AtRatio:
    """What a mechanism would be at one lambda."""

    ratio: float
    start: float  # theta_1m [rad]
    step_min: float  # phi_p,min [rad]: for a smaller step lambda_min is above this lambda
    step_max: float  # phi_p,max [rad]
    handover: Handover | None  # None: no such mechanism, or the law is known by its B alone


@record
class Compared:
    """One law with one number of rollers."""

    law: str
    peak: float  # B
    rollers: int
    low: AtRatio  # at lambda_min
    high: AtRatio | None  # at lambda_max; None: lambda is not limited
    given: AtRatio | None  # at the lambda of the task; None: it is left open
    most: int | None  # z2_max of the law
    possible: bool  # a lambda lies between the limits, a miss of 1.5 % tolerated, and the lobe has a tip


def compare(task: IndexingTask) -> tuple[Compared, ...]:
    """The law of the task over z2, then all laws at its z2; all with the step and the pressure angle of the task."""
    over = [replace(task, rollers=z2) for z2 in dict.fromkeys((*ROLLERS, task.rollers))]
    rest = [replace(task, law=law) for law in _laws() if law.name != task.law.name]
    return tuple(map(compared, (*over, *rest)))


def _laws() -> Iterator[StepLaw]:
    yield from map(step_law, symmetric_laws())
    yield from map(step_law, CODES)
    yield TABLED


def compared(task: IndexingTask) -> Compared:
    """One row of the comparison."""
    limits = bounds(task.law.peak, task.rollers, task.step, task.limit)
    most = limits.ratio_max
    low = _at(task, limits.ratio_min)
    exists = task.law.law is None or low.handover is not None
    return Compared(
        law=task.law.name,
        peak=task.law.peak,
        rollers=task.rollers,
        low=low,
        high=None if most is None else _at(task, most),
        given=None if task.ratio is None else _at(task, task.ratio),
        most=most_rollers(task),
        possible=exists and limits.excess <= TOLERATED,
    )


def _at(task: IndexingTask, ratio: float) -> AtRatio:
    drive = drive_of(task, ratio)
    return AtRatio(
        ratio=ratio,
        start=start_pressure(task.rollers, ratio),
        step_min=least_step(task.law.peak, task.rollers, ratio),
        step_max=largest_step(task.rollers, ratio),
        handover=None if drive is None else handover(drive),
    )


def compared_columns(rows: tuple[Compared, ...]) -> dict[str, list[Any]]:
    """Columns by their headers, angles in degrees; an empty cell where there is no such value."""
    columns: dict[str, list[Any]] = {
        "law": [row.law for row in rows],
        "z2": [row.rollers for row in rows],
        "B": [row.peak for row in rows],
    }
    for end, places in (("min", [row.low for row in rows]), ("max", [row.high for row in rows])):
        columns |= _end_columns(end, places)
    if rows[0].given is not None:
        columns |= _end_columns("given", [row.given for row in rows])
    return {
        **columns,
        "z2_max": ["" if row.most is None else row.most for row in rows],
        "possible": ["yes" if row.possible else "no" for row in rows],
    }


def _end_columns(end: str, places: Sequence[AtRatio | None]) -> dict[str, list[Any]]:
    """The columns at one lambda."""
    tips = [None if place is None else place.handover for place in places]
    return {
        f"lambda_{end}": ["" if place is None else place.ratio for place in places],
        f"theta1m_{end}[deg]": ["" if place is None else degrees(place.start) for place in places],
        f"k_m_{end}": ["" if tip is None else tip.part for tip in tips],
        f"theta2_{end}[deg]": ["" if tip is None else degrees(tip.angle) for tip in tips],
        f"source2_{end}[deg]": ["" if tip is None else degrees(tip.source_angle) for tip in tips],
        f"least_step_{end}[deg]": ["" if place is None else degrees(place.step_min) for place in places],
        f"largest_step_{end}[deg]": ["" if place is None else degrees(place.step_max) for place in places],
    }
