"""Ranges of the joints: by how much and when they are passed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.results import LimitExcess
from tmmcalc.manipulators.task import JointLimit
from tmmcalc.numerics.panels import Values
from tmmcalc.numerics.roots import bracketed
from tmmcalc.timerows import TimedExtreme

SAME = 1e-12  # of the size of a coordinate: what passes its limit by less, keeps it
SAMPLES = 721  # among which the first passing is sought


def find_excesses(
    limits: Sequence[JointLimit],
    angular: Sequence[bool],
    reached: Sequence[TimedExtreme],
    joint: Callable[[int, Values], Values],
    duration: float,
) -> tuple[LimitExcess, ...]:
    """What passes its limits: ``reached`` and ``joint(k, t)`` are extremes and coordinates of the limited joints."""
    found = []
    for k, (limit, turns, extreme) in enumerate(zip(limits, angular, reached, strict=True)):
        for edge, value, t, sign in (
            (limit.low, extreme.least, extreme.least_at, -1.0),
            (limit.high, extreme.largest, extreme.largest_at, 1.0),
        ):
            if edge is not None and sign * (value - edge) > SAME * max(abs(edge), abs(value)):
                first = _first(lambda at, k=k, e=edge, s=sign: s * (joint(k, at) - e), duration, t)  # type: ignore[misc]
                found.append(LimitExcess(limit.name, turns, edge, value, t, first))
    return tuple(found)


def _first(beyond: Callable[[Values], Values], duration: float, last: float) -> float:
    """The first time at which a function is above zero, at the latest ``last``."""
    t = np.linspace(0.0, duration, SAMPLES)
    over = np.flatnonzero(beyond(t) > 0)
    if not over.size or t[over[0]] > last:
        return last
    if over[0] == 0:
        return 0.0
    return float(bracketed(lambda at, _: beyond(at), t[over[0] - 1 : over[0]], t[over[0] : over[0] + 1])[0])


def excess_grades(excesses: Sequence[LimitExcess]) -> tuple[Grade, ...]:
    """A warning for each."""
    return tuple(Grade("warning", f"joint {each.joint}", _words(each)) for each in excesses)


def _words(each: LimitExcess) -> str:
    factor, unit = (180 / math.pi, "deg") if each.angular else (1.0, "m")
    value, limit, excess = (factor * v for v in (each.value, each.limit, each.excess))
    return (
        f"{value:.7g} {unit} at t = {each.t:.6g} s passes its limit of {limit:.7g} {unit} by {excess:.4g} {unit}; "
        f"it is first beyond it at t = {each.first:.6g} s"
    )
