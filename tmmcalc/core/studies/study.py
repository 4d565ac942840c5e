"""The records of a study: methods, each at several settings, with their errors against one reference and their times.

    Study    one quantity of one stage            "velocities of all points"
    Series   one method                           "central differences"
    Point    one setting of it                    step 1.5 deg: error 2e-4 in 0.3 ms

Errors are the largest over all positions, relative to the largest magnitude of the quantity, and never below half a
rounding unit, which is as near as two numbers in double precision can be told apart.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field

from tmmcalc.core.errors import TmmError
from tmmcalc.core.records import record

FLOOR = 2.0**-53


@record
class Reference:
    """What the errors are measured against: how it was found, and its own relative error as far as it is known."""

    name: str
    error: float


@record
class Point:
    """One setting of a method: its size (a step, a tolerance), largest relative error, median time [s] of its runs.

    ``failed`` says why it gave no result; the error is None then. A setting without a size is one of a kind, or a
    number of passes, of terms.
    """

    setting: str
    size: float | None
    error: float | None
    seconds: float | None
    count: int | None = None  # of what costs: evaluations of equations, points of a polygon, terms, tooth sets
    failed: str = ""
    runs: int = 0  # that the time is the median of


@record
class Series:
    """A method at its settings, from coarse to fine."""

    method: str
    points: tuple[Point, ...]
    order: float | None = None  # observed: error ~ size^order
    expected: float | None = None  # what theory says of it
    note: str = ""

    @property
    def best(self) -> Point | None:
        """The setting with the least error; None if none gave a result."""
        told = [point for point in self.points if point.error is not None]
        return min(told, key=lambda point: point.error or 0.0) if told else None

    @property
    def sure(self) -> tuple[tuple[Point, float], ...]:
        """The settings with a result, each with the error that it and all finer ones keep.

        So what is near the truth by chance counts as its neighbours do. Settings at the fine end whose errors only
        rise, since rounding takes over, say nothing against the coarser ones.
        """
        told = [point for point in self.points if point.error is not None]
        errors = [point.error or 0.0 for point in told]
        turn = len(told) - 1
        while turn > 0 and errors[turn] >= errors[turn - 1]:
            turn -= 1
        kept = [max(errors[min(k, turn) : max(k, turn) + 1]) for k in range(len(told))]
        return tuple(zip(told, kept, strict=True))

    def cheapest(self, tolerance: float) -> Point | None:
        """The setting with the least time among those that keep ``tolerance``, as all finer ones do, if any."""
        within = [point for point, kept in self.sure if kept <= tolerance]
        return min(within, key=lambda point: point.seconds or 0.0) if within else None


@record
class Study:
    """All methods for one quantity of a stage."""

    stage: str
    quantity: str
    reference: Reference
    series: tuple[Series, ...]

    def cheapest(self, tolerance: float) -> tuple[Series, Point] | None:
        """The method and setting with the least time among those that keep ``tolerance``, if any."""
        found = [(series, series.cheapest(tolerance)) for series in self.series]
        within = [(series, point) for series, point in found if point is not None]
        return min(within, key=lambda each: each[1].seconds or 0.0) if within else None

    @property
    def front(self) -> tuple[tuple[Series, Point, float], ...]:
        """The settings that no other beats in both time and the error that it keeps, and that error, by time."""
        told = [(point.seconds or 0.0, kept, series, point) for series in self.series for point, kept in series.sure]
        best, least = [], math.inf
        for _, kept, series, point in sorted(told, key=lambda each: each[:2]):
            if kept < least:
                best.append((series, point, kept))
                least = kept
        return tuple(best)


@record
class Rung:
    """One stiffness of a ladder: what the textbook's fixed step would take, and what the program's choice took."""

    value: float  # of what makes it stiff
    fastest: float  # time constant [s]
    limit: float  # longest fixed step that stays bounded [s]
    steps: float  # fixed steps of that length over the duration
    textbook_evaluations: int  # of the equations, in those steps
    textbook_error: float | None  # of the speeds with the step that the textbook takes; None: no result, or not known
    textbook_fails: str  # why that step gives no result; empty: it does
    method: str  # the program's choice
    rigid: bool  # it takes a shaft as rigid
    evaluations: int
    seconds: float  # median [s]
    error: float  # of the speeds, relative to the largest; where there is no reference its own estimate
    reference: float  # estimated error of the reference; 0: none


@record
class Ladder:
    """A drive made stiffer from rung to rung."""

    stage: str
    quantity: str
    unit: str
    duration: float  # of the motion [s]
    step: float  # that the textbook takes [s]
    reference: Reference
    rungs: tuple[Rung, ...]
    power: float | None  # the limit of the fixed step goes as the value to this power, where it is the fast part


@record
class Accuracy:
    """The studies of a scene, ladders of stiffness, and the stages of it that could not be studied."""

    studies: tuple[Study, ...]
    without: tuple[str, ...]  # stages with one method only
    ladders: tuple[Ladder, ...] = ()
    settled: tuple[str, ...] = ()  # stages whose choice this scene leaves no room for
    failures: Mapping[str, TmmError] = field(default_factory=dict)  # of stages without a result
