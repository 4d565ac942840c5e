"""The records of a study: methods, each at several settings, with their errors against one reference and their times.

    Study    one quantity of one stage            "velocities of all points"
    Series   one method                           "central differences"
    Point    one setting of it                    step 1.5 deg: error 2e-4 in 0.3 ms

Errors are the largest over all positions, relative to the largest magnitude of the quantity, and never below half a
rounding unit, which is as near as two numbers in double precision can be told apart.
"""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.records import record

FLOOR = 2.0**-53


@record
class Reference:
    """What the errors are measured against: how it was found, and its own relative error as far as it is known."""

    name: str
    error: float


@record
class Point:
    """One setting of a method: its size (a step, a tolerance, a count), largest relative error, median time [s].

    ``failed`` says why it gave no result; error and time are None then.
    """

    setting: str
    size: float
    error: float | None
    seconds: float | None
    evaluations: int | None = None  # of the functions that cost, where the method counts them
    failed: str = ""


@record
class Series:
    """A method at its settings, from coarse to fine."""

    method: str
    points: tuple[Point, ...]
    order: float | None = None  # observed: error ~ size^order
    expected: float | None = None  # what theory says of it
    note: str = ""


@record
class Study:
    """All methods for one quantity of a stage."""

    stage: str
    quantity: str
    reference: Reference
    series: tuple[Series, ...]

    def cheapest(self, tolerance: float) -> tuple[Series, Point] | None:
        """The method and setting with the least time among those whose error is within ``tolerance``, if any."""
        within = [
            (point.seconds, series, point)
            for series in self.series
            for point in series.points
            if point.error is not None and point.seconds is not None and point.error <= tolerance
        ]
        return min(within, key=lambda item: item[0])[1:] if within else None


@record
class Accuracy:
    """The studies of a scene, and the stages of it that have no choice of method."""

    studies: tuple[Study, ...]
    without: tuple[str, ...]


def pareto(points: Sequence[Point]) -> tuple[Point, ...]:
    """The points that no other beats in both error and time, by rising time."""
    told = [p for p in points if p.error is not None and p.seconds is not None]
    best: list[Point] = []
    for point in sorted(told, key=lambda p: (p.seconds, p.error)):
        if not best or (point.error or 0.0) < (best[-1].error or 0.0):
            best.append(point)
    return tuple(best)
