"""Timing of calls, for `make bench`."""

from __future__ import annotations

import statistics
from collections.abc import Callable
from time import perf_counter


def median_time(work: Callable[[], object], least: float = 0.4) -> float:
    """Median seconds of one call, over at least 5 calls and ``least`` seconds."""
    work()
    times: list[float] = []
    while len(times) < 5 or sum(times) < least:
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return statistics.median(times)


def bar_text(value: float, bar: float) -> str:
    """The bar, and whether it is missed."""
    return f"{bar:6g} {'' if value <= bar else 'MISSED'}"
