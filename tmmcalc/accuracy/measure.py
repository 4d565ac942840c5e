"""Running a method at one setting: its error, and the median time of several runs."""

from __future__ import annotations

import gc
import statistics
from collections.abc import Callable, Iterable
from time import perf_counter
from typing import Any, TypeVar

import numpy as np

from tmmcalc.accuracy.order import observed
from tmmcalc.accuracy.study import FLOOR, Point, Series
from tmmcalc.errors import TmmError
from tmmcalc.records import record

Found = TypeVar("Found")
Numbers = Any  # array of numbers (..., n), real or complex


LONG = 2.0  # times the budget: of a run as long as this, imports are a small part


USELESS = 1.0  # an error as large as the quantity itself


@record
class Way:
    """A setting to be measured: its name, its size, and what runs it; ``solve`` returns what ``error`` takes."""

    setting: str
    size: float
    solve: Callable[[], Any]
    evaluations: Callable[[Any], int] | None = None


@record
class Clock:
    """How often a way is run: ``repeats`` times at most, no longer than ``budget`` [s] once it ran ``least`` times."""

    repeats: int = 7
    budget: float = 0.4
    least: int = 1

    def median(self, solve: Callable[[], Found]) -> tuple[Found, float]:
        """The last result and the median time [s]; the first run, which imports and allocates, counts if it is long."""
        began = perf_counter()
        found = solve()
        first = perf_counter() - began
        if first > LONG * self.budget:
            return found, first
        times: list[float] = []
        on = gc.isenabled()
        gc.disable()
        try:
            while len(times) < self.repeats and (len(times) < self.least or sum(times) < self.budget):
                began = perf_counter()
                found = solve()
                times.append(perf_counter() - began)
        finally:
            if on:
                gc.enable()
        return found, statistics.median(times)


def relative(found: Numbers, exact: Numbers) -> float:
    """Largest difference (..., n) over the largest magnitude of the exact values; `FLOOR` at least."""
    found, exact = np.asarray(found), np.asarray(exact)
    scale = float(np.max(np.abs(exact), initial=0.0))
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
) -> Series:
    """Measure a method at all its settings; one that raises a `TmmError` is kept with its reason."""
    points = tuple(_point(way, error, clock) for way in ways)
    told = [(p.size, p.error) for p in points if p.error is not None]
    order = observed([size for size, _ in told], [e for _, e in told]) if len(told) > 1 else None
    return Series(method, points, order, expected, note)


def _point(way: Way, error: Callable[[Any], float], clock: Clock) -> Point:
    try:
        found, seconds = clock.median(way.solve)
    except TmmError as fault:
        return Point(way.setting, way.size, None, None, failed=fault.message.splitlines()[0])
    count = way.evaluations(found) if way.evaluations else None
    missed = error(found)
    if not missed < USELESS:
        return Point(way.setting, way.size, None, seconds, count, failed="the result is wrong altogether")
    return Point(way.setting, way.size, missed, seconds, count)
