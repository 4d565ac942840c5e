"""Where an unsteady motion begins and ends: input coordinates, given or sought from values of an output.

Of several positions with the same value of the output the one nearest to where the motion comes from is taken, on the
asked side if there is one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.extrema import around, refine, turning
from tmmcalc.core.numerics.roots import Problems, bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN, coordinate, describe
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import coordinate_of, output_named
from tmmcalc.linkage.results import Domain, Interval
from tmmcalc.linkage.survey import survey
from tmmcalc.linkage.unsteady.task import UnsteadyTask

WHERE = "unsteady"
SAME = 1e-9  # of the searched range: nearer coordinates are one
CLEAR = 1e-9  # of a range: the survey keeps so far from its ends, which may be limit positions; no way is shorter
LAST = 1e-14  # of the searched range: so near to a limit position rounding may part the links
NEAR_LIMIT = 1e-10  # of the searched range: from where values are carried on to a limit position
REACHED = 1e-12  # of the range of an output: a value beyond it by less is its extreme


class Ends(NamedTuple):
    """Input coordinates of the begin and of the end [rad or m]; no end where the duration alone settles it."""

    start: float
    end: float | None


def find_ends(chain: Chain, domain: Domain, task: UnsteadyTask, reference: float) -> Ends:
    """Begin and end of the motion; ``reference`` is the coordinate of position 0.

    Raises `NoSolutionError` for a value that the output does not reach, `UsageError` for an output that is none.
    """
    output = None if task.output is None else output_named(chain, task.output, WHERE)
    start = reference
    if task.start is not None:
        start = task.start if output is None else _nearest(chain, domain, output, task.start, reference, None)
    if task.travel is not None:
        return Ends(start, start + task.travel)
    if task.end is None:
        return Ends(start, None)
    if output is not None:
        return Ends(start, _nearest(chain, domain, output, task.end, start, task.sense))
    return Ends(start, start + _way(chain, task.end - start, task.sense))


def _way(chain: Chain, travel: float, sense: int | None) -> float:
    """The travel to the asked side; of a crank whole turns are added where they are needed."""
    if sense is None or travel * sense >= 0:
        return travel
    if not chain.turns:
        raise NoSolutionError(
            f"the end lies {abs(travel) * 1000:.9g} mm to the other side of the start than the sense asks for",
            where=WHERE,
            value=travel,
            remedy="leave sense out",
        )
    return travel - TURN * math.floor(travel * sense / TURN) * sense


def _nearest(chain: Chain, domain: Domain, output: Output, value: float, near: float, sense: int | None) -> float:
    """The input coordinate nearest to ``near`` at which the output has this value."""
    low, high = _range(chain, domain, near)
    least_way = CLEAR * (high - low)
    if sense is not None:
        low, high = (near, high) if sense > 0 else (low, near)
    side = "" if sense is None else f" on the {'positive' if sense > 0 else 'negative'} side"
    if high - low <= least_way:
        raise _outside(chain, domain.intervals, near, f"from {coordinate(chain, near)} the mechanism has no way{side}")
    found, least, largest = _roots(chain, output, value, low, high)
    if math.isnan(least):
        raise _outside(chain, domain.intervals, near, f"from {coordinate(chain, near)} the mechanism has no way{side}")
    if not len(found):
        angle = output.link is not None
        shown = [math.degrees(v) if angle else v for v in (value, least, largest)]
        unit = "deg" if angle else "m"
        reach = f"{shown[1]:.9g} to {shown[2]:.9g} {unit}"
        raise NoSolutionError(
            f"output {output.name} never is {shown[0]:.9g} {unit}: it reaches from {reach}{side}",
            where=WHERE,
            value=value,
            limit=least if value < least else largest,
            remedy=f"ask for a value within {reach}, or change the lengths",
        )
    return float(found[np.argmin(np.abs(found - near))])


def _range(chain: Chain, domain: Domain, near: float) -> tuple[float, float]:
    """The range of the input to search: a turn to each side, or the assembly interval about ``near``."""
    if domain.full and chain.turns:
        return near - TURN, near + TURN
    for interval in domain.intervals:
        shift = TURN * math.floor((near - interval.low) / TURN) if chain.turns else 0.0
        if interval.low <= near - shift <= interval.high:
            return interval.low + shift, interval.high + shift
    raise _outside(chain, domain.intervals, near, "the motion would begin where the mechanism does not assemble")


def _outside(chain: Chain, intervals: tuple[Interval, ...], near: float, fault: str) -> NoSolutionError:
    ranges = " and ".join(describe(chain, interval) for interval in intervals)
    return NoSolutionError(
        f"{fault}: it assembles for {ranges} only", where=WHERE, value=near, remedy="begin within that range"
    )


def _roots(chain: Chain, output: Output, value: float, low: float, high: float) -> tuple[Real, float, float]:
    """Coordinates (m,) in the range at which the output has the value, and its extremes; angles modulo 2 pi.

    The extremes are not a number where the range is so short that rounding parts its links.
    """
    clear = CLEAR * (high - low)
    dense = survey(chain, low + clear, high - clear)
    track = dense.angle(output.link) if output.link is not None else None

    def inside(at: Real) -> Real:
        raw = np.broadcast_to(coordinate_of(chain, output, chain.evaluate(at, order=0))[0], at.shape)
        if track is None:
            return raw
        return raw + TURN * np.rint((np.interp(at, dense.x, track) - raw) / TURN)

    ends = np.array([low, high])
    limits = _carried_on(inside, low, high)

    def f(at: Real, _: object) -> Real:
        end = np.argmin(np.abs(at - ends[:, None]), axis=0)
        return np.where(np.abs(at - ends[end]) <= LAST * (high - low), limits[end], inside(at))

    x, values = _with_extremes(f, np.concatenate(([low], dense.x, [high])))
    if not len(x):
        return np.empty(0), math.nan, math.nan
    least, largest = float(values.min()), float(values.max())
    touch = REACHED * (largest - least)
    turns = [0.0]
    if track is not None:
        turns = [TURN * k for k in range(math.ceil((least - value) / TURN), math.floor((largest - value) / TURN) + 1)]
    parts = [_level(f, x, values, value + turn, touch) for turn in turns]
    return np.sort(np.concatenate([np.empty(0), *parts])), least, largest


def _carried_on(f: Callable[[Real], Real], low: float, high: float) -> Real:
    """Values (2,) of a function at the ends of a range, which may be limit positions: there it goes as sqrt(distance).

    They are carried on from three points inside at equal steps of that root, exactly for squares of it.
    """
    step = math.sqrt(NEAR_LIMIT * (high - low))
    inner = (step * np.arange(1, 4)) ** 2
    return np.array([np.dot((3.0, -3.0, 1.0), f(end + side * inner)) for end, side in ((low, 1), (high, -1))])


def _with_extremes(f: Problems, x: Real) -> tuple[Real, Real]:
    """Samples of a function at ``x`` (m,) and at all its local extremes, in order; none where rounding parts a link."""
    values = f(x, np.arange(len(x)))
    assembled = np.isfinite(values)
    x, values = x[assembled], values[assembled]
    if len(x) < 2:
        return x, values
    at = np.concatenate([turning(values, sign, False) for sign in (1, -1)])
    place, value = refine(f, *around(x, at, False))
    x, values = np.concatenate((x, place)), np.concatenate((values, value))
    order = np.argsort(x, kind="stable")
    return x[order], values[order]


def _level(f: Problems, x: Real, values: Real, level: float, touch: float) -> Real:
    """Where the samples pass a level, exactly; an extreme within ``touch`` of it counts."""
    off = values - level
    at = np.flatnonzero(np.abs(off) <= touch)
    change = np.flatnonzero(np.signbit(off[1:]) != np.signbit(off[:-1]))
    found = bracketed(lambda where, which: f(where, which) - level, x[change], x[change + 1])
    found = np.sort(np.concatenate((found, x[at])))
    apart = np.append(True, np.diff(found) > SAME * (x[-1] - x[0]))
    return found[apart] if len(found) else found
