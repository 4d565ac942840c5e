"""Running a method at one setting: its error, and the median time of several runs."""

from __future__ import annotations

import gc
import statistics
from collections.abc import Callable, Iterable, Sequence
from time import perf_counter
from typing import Any, TypeVar

import numpy as np

from tmmcalc.core.errors import TmmError
from tmmcalc.core.records import record
from tmmcalc.core.studies.order import observed
from tmmcalc.core.studies.study import FLOOR, Point, Series

Found = TypeVar("Found")
Numbers = Any  # array of numbers (..., n), real or complex

USELESS = 1.0  # an error as large as the quantity itself
WRONG = "the error is as large as the quantity itself"


@record
class Way:
    """A setting to be measured: its name, its size, and what runs it; ``solve`` returns what ``error`` takes.

    ``count`` tells of a result how much of what costs went into it.
    """

    setting: str
    size: float | None
    solve: Callable[[], Any]
    count: Callable[[Any], int] | None = None


@record
class Clock:
    """How often a way is run: ``repeats`` times at most, and as long as all its runs are within the ``budget`` [s].

    So what takes longer than the budget is run once; its time scatters by little.
    """

    repeats: int = 7
    budget: float = 0.2

    def median(self, solve: Callable[[], Found], fresh: bool = True) -> tuple[Found, float, int]:
        """The last result, the median time [s] and of how many runs.

        The first run of a ``fresh`` method, which imports and allocates, does not count.
        """
        times: list[float] = []
        on = gc.isenabled()
        gc.disable()
        try:
            if fresh:
                solve()
            while not times or (len(times) < self.repeats and sum(times) < self.budget):
                began = perf_counter()
                found = solve()
                times.append(perf_counter() - began)
        finally:
            if on:
                gc.enable()
        return found, statistics.median(times), len(times)


def relative(found: Numbers, exact: Numbers, size: float | None = None) -> float:
    """Largest difference (..., n) over the ``size``, by default the largest magnitude of the exact values.

    `FLOOR` at least; the difference itself where the size is 0.
    """
    found, exact = np.asarray(found), np.asarray(exact)
    scale = float(np.max(np.abs(exact), initial=0.0)) if size is None else size
    worst = float(np.max(np.abs(found - exact), initial=0.0))
    return max(worst / scale if scale else worst, FLOOR)


def series(
    method: str,
    ways: Iterable[Way],
    error: Callable[[Any], float],
    clock: Clock,
    *,
    expected: float | None = None,
    note: str = "",
    stepwise: bool = True,
) -> Series:
    """Measure a method at all its settings; one that raises a `TmmError` is kept with its reason.

    Unless its settings are ``stepwise``, their sizes being steps, it has no order of convergence: not where sizes are
    tolerances, not beyond every order, and not where chance decides how near a setting comes.
    """
    return by_quantity(method, ways, (error,), clock, expected=(expected,), note=note, stepwise=stepwise)[0]


def by_quantity(
    method: str,
    ways: Iterable[Way],
    errors: Sequence[Callable[[Any], float]],
    clock: Clock,
    *,
    expected: Sequence[float | None] = (),
    note: str = "",
    stepwise: bool = True,
) -> tuple[Series, ...]:
    """The same for several quantities that a method finds together: a series for each of their ``errors``."""
    rows = [_points(way, errors, clock, fresh=k == 0) for k, way in enumerate(ways)]
    columns = list(zip(*rows, strict=True)) or [()] * len(errors)
    found = []
    for points, theory in zip(columns, expected or [None] * len(errors), strict=True):
        told = [(p.size, p.error) for p in points if p.size is not None and p.error is not None and stepwise]
        order = observed([size for size, _ in told], [e for _, e in told]) if len(told) > 1 else None
        found.append(Series(method, points, order, theory, note))
    return tuple(found)


def _points(way: Way, errors: Sequence[Callable[[Any], float]], clock: Clock, fresh: bool) -> list[Point]:
    """The setting as it is judged by each of the errors."""
    try:
        found, seconds, runs = clock.median(way.solve, fresh)
    except TmmError as fault:
        failed = fault.message.splitlines()[0]
        return [Point(way.setting, way.size, None, None, failed=failed) for _ in errors]
    count = way.count(found) if way.count else None
    points = []
    for error in errors:
        missed = error(found)
        wrong = not missed < USELESS
        told = None if wrong else missed
        points.append(Point(way.setting, way.size, told, seconds, count, WRONG if wrong else "", runs))
    return points
