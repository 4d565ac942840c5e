"""Ranges of the joints and of the elbow: by how much and when they are passed."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Values, resolved
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.timerows import RESOLVED, over_time
from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.motions import Motion
from tmmcalc.manipulators.results import LimitExcess
from tmmcalc.manipulators.task import JointLimit

SAME = 1e-12  # of the size of a coordinate: what passes its limit by less, keeps it


def find_excesses(moved: Motion, limits: Sequence[JointLimit]) -> tuple[LimitExcess, ...]:
    """What passes its limits, with the farthest value and the first instant beyond."""
    if not limits:
        return ()
    names = [joint.name for joint in moved.arm.ranged]
    rows = [names.index(limit.name) for limit in limits]
    tracks = _local_extremes(moved, rows)
    found = (
        _excess(moved, k, track, (limit.name, edge, sign))
        for limit, k, track in zip(limits, rows, tracks, strict=True)
        for edge, sign in ((limit.low, -1.0), (limit.high, 1.0))
        if edge is not None
    )
    return tuple(each for each in found if each is not None)


def _local_extremes(moved: Motion, rows: Sequence[int]) -> list[tuple[Values, Values]]:
    """Times and values (m,) of the local extremes and of the breaks of coordinates, in the order of time."""

    def coordinates(t: Values) -> Values:
        return moved.ranged(t)[0, rows]

    duration = moved.given.duration
    if not duration:
        begin: Values = np.zeros(1)
        return [(begin, value[None]) for value in coordinates(begin)[:, 0]]
    on, values, _ = resolved(coordinates, over_time(duration, moved.given.breaks), RESOLVED)
    found: list[tuple[Values, Values]] = []
    for row in values:
        at, value = on.turning(row)
        order = np.argsort(at, kind="stable")
        found.append((at[order], value[order]))
    return found


def _excess(
    moved: Motion, row: int, track: tuple[Values, Values], limit: tuple[str, float, float]
) -> LimitExcess | None:
    """How a coordinate passes one end of its range: its name, the end, and -1 for the lower or +1 for the upper one."""
    name, edge, sign = limit
    at, value = track
    beyond = sign * (value - edge)
    far = int(np.argmax(beyond))
    if beyond[far] <= SAME * max(abs(edge), abs(float(value[far]))):
        return None
    k = int(np.flatnonzero(beyond > 0)[0])

    def past(t: Values, _: Indices) -> Values:
        return np.asarray(sign * (moved.ranged(t)[0, row] - edge))

    # between two neighbouring extremes a coordinate passes its limit once
    first = float(bracketed(past, at[k - 1 : k], at[k : k + 1])[0]) if k else float(at[0])
    return LimitExcess(name, moved.arm.ranged[row].turns, edge, float(value[far]), float(at[far]), first)


def excess_grades(excesses: Sequence[LimitExcess]) -> tuple[Grade, ...]:
    """A warning for each."""
    return tuple(Grade("warning", Phrase("joint {joint}", joint=each.joint), _words(each)) for each in excesses)


def _words(each: LimitExcess) -> str:
    factor, unit = (180 / math.pi, "deg") if each.angular else (1.0, "m")
    value, limit, excess = (factor * v for v in (each.value, each.limit, each.excess))
    return Phrase(
        "{value:.7g} {unit} at t = {t:.6g} s passes its limit of {limit:.7g} {unit} by {excess:.4g} {unit}; it is "
        "first beyond it at t = {first:.6g} s",
        value=value,
        unit=unit,
        t=each.t,
        limit=limit,
        excess=excess,
        first=each.first,
    )
