"""Numbers of rollers and laws side by side: pressure angles, tips of the lobe and limits of the step at three lambda.

The reference tables of the method are of this kind: one law over z2, all laws at one z2, and the limits of the step.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from tmmcalc.cams.indexing.bounds import TOLERATED, bounds, largest_step, least_step, start_pressure
from tmmcalc.cams.indexing.choice import ROLLERS, most_rollers
from tmmcalc.cams.indexing.handover import Handover, handover
from tmmcalc.cams.indexing.laws import StepLaw, step_law, symmetric_laws
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.quantity import derived, quantity, quantity_of, table
from tmmcalc.core.records import record

AT_RATIO = ("ratio", "start", "tip", "takeover", "source", "step_min", "step_max")
CODES = ("0010",)  # laws of the printed tables beside the catalogue; 0000 is linear, 0050 is const
TABLED = StepLaw("2.9 (its B alone)", 1.625)  # of the printed tables, not identified: poly5 has all its values but one


@record
class AtRatio:
    """What a mechanism would be at one lambda."""

    ratio: float = quantity("lambda{at}", "centre distance over the radius of the wheel")
    start: float = quantity("theta1m{at}[rad]", "pressure angle at the start of the step", symbol="theta_1m")
    step_min: float = quantity("least_step{at}[rad]", "step below which lambda_min is above this lambda")
    step_max: float = quantity("largest_step{at}[rad]", "largest angle of the step that is recommended")
    handover: Handover | None  # None: no such mechanism, or the law is known by its B alone

    @derived("k_m{at}", "part of the step at which B takes over")
    def tip(self) -> float | None:
        """None: no tip."""
        return None if self.handover is None else self.handover.part

    @derived("theta2{at}[rad]", "pressure angle with which B takes over", symbol="theta_2")
    def takeover(self) -> float | None:
        """None: no tip."""
        return None if self.handover is None else self.handover.angle

    @derived("source2{at}[rad]", "theta_2 as the printed tables have it")
    def source(self) -> float | None:
        """None: no tip."""
        return None if self.handover is None else self.handover.source_angle


@record
class Compared:
    """One law with one number of rollers."""

    law: str = quantity("law", "law of motion of the wheel")
    peak: float = quantity("B", "largest s' of the law")
    rollers: int = quantity("z2", "number of rollers", symbol="z_2")
    low: AtRatio  # at lambda_min
    high: AtRatio | None  # at lambda_max; None: lambda is not limited
    given: AtRatio | None  # at the lambda of the task; None: it is left open
    most: int | None = quantity("z2_max", "largest number of rollers of the law")
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
    columns = table(rows, Compared, "law", "rollers", "peak")
    for end, places in (("min", [row.low for row in rows]), ("max", [row.high for row in rows])):
        columns |= _end_columns(end, places)
    if rows[0].given is not None:
        columns |= _end_columns("given", [row.given for row in rows])
    return {
        **columns,
        quantity_of(Compared, "most").key: ["" if row.most is None else row.most for row in rows],
        "possible": ["yes" if row.possible else "no" for row in rows],
    }


def _end_columns(end: str, places: Sequence[AtRatio | None]) -> dict[str, list[Any]]:
    """The columns at one lambda."""
    found = {}
    for name in AT_RATIO:
        values = (None if place is None else getattr(place, name) for place in places)
        header, factor = at_ratio(name, f"_{end}")
        found[header] = ["" if value is None else factor * value for value in values]
    return found


def at_ratio(name: str, end: str) -> tuple[str, float]:
    """The header of a column at one lambda, angles in degrees, and the factor of its values."""
    told = quantity_of(AtRatio, name, at=end)
    return told.shown("deg") if told.unit else (told.key, 1.0)
