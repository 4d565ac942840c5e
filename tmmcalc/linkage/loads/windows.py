"""Windows: where along the motion a load acts - on a stroke of an output, between angles, between positions.

Windows are closed: a load counts at both ends. At the seam of the cycle position 0 takes what holds just after it
and the last position what holds just before. A window comes back every turn; only one that names angles beyond the
first turn, or that belongs to a law with a longer period, comes back after that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.strokes import Strokes, strokes_of
from tmmcalc.linkage.loads.travel import EDGE, Travel
from tmmcalc.linkage.results import Grade, Kinematics

Flags = NDArray[np.bool_]


class Inside(NamedTuple):
    """Where a load acts: the test of a place, the angle since the window began, theta of all its ends."""

    inside: Callable[[Place], Any]
    since: Callable[[Real], Real]
    edges: list[float]
    begins: tuple[float, ...] = ()  # theta at which the window begins, of all turns of a cycle
    ends: tuple[float, ...] = ()
    grades: tuple[Grade, ...] = ()


def window_of(chain: Chain, kinematics: Kinematics, travel: Travel, load: Load) -> Inside:
    """The window of a load; raises `NoSolutionError` for a stroke or a position that is not there."""
    window, where = load.window, Phrase("load {name}", name=load.name)
    own = TURN * load.turns
    if window is None:
        edges = travel.repeated([0.0], own) if load.law.counted else []
        return Inside(lambda place: True, lambda theta: travel.since(0.0, theta, own), edges)
    if window.stroke is not None:
        which = 0 if window.stroke == "working" else 1
        return _stroke(travel, strokes_of(chain, kinematics, travel, window.output, where), which)
    low, high = window.angles or _angles(window.positions or ("0", "0"), travel, where)
    return _between(travel, low, high, own, where)


def _stroke(travel: Travel, strokes: Strokes, which: int) -> Inside:
    def since(theta: Real) -> Real:
        beginnings = strokes.beginnings[which]
        if travel.whole:
            return np.min([travel.since(b, theta, TURN) for b in beginnings], axis=0)
        return np.min([np.where(theta < b - EDGE, travel.period, theta - b) for b in beginnings], axis=0)

    edges = travel.repeated(strokes.turning)
    begins, ends = (tuple(travel.repeated(strokes.beginnings[k])) for k in (which, 1 - which))
    return Inside(lambda place: strokes.on(place, which), since, edges, begins, ends)


def _between(travel: Travel, low: float, high: float, own: float, where: str) -> Inside:
    if not travel.whole:
        if low > high:
            raise NoSolutionError(
                f"the window ends at {travel.named(np.array([high]))[0]}, before it begins",
                where=where,
                remedy="name its ends in the order of the motion: a motion that is no cycle passes each place once",
            )
        own_range = (lambda place: _within(place.theta, low, high)), (lambda t: travel.since(low, t, own))
        return Inside(*own_range, [low, high], (low,), (high,), tuple(_beyond(travel, low, high, where)))
    period = own if max(low, high) <= own + EDGE else travel.period
    low, high = low % period, high % period or period

    def inside(place: Place) -> Flags:
        theta = place.theta
        reduced = np.mod(theta + EDGE, period) - EDGE
        seam = (reduced < EDGE) & (theta > EDGE)
        before, after = _within(np.asarray(period), low, high), _within(reduced, low, high)
        return np.where(seam, before | (after & ~travel.ends(theta)), after)

    begins, ends = travel.repeated([low], period), travel.repeated([high], period)
    return Inside(inside, lambda t: travel.since(low, t, period), [*begins, *ends], tuple(begins), tuple(ends))


def _beyond(travel: Travel, low: float, high: float, where: str) -> Iterator[Grade]:
    """What of a window the motion never reaches; a part of a turn may well be analysed on purpose."""
    if high <= travel.period + EDGE:
        return
    begins, ends, last = travel.named(np.array([low, high, travel.period]))
    severity: Literal["note", "warning"] = "note" if travel.turns else "warning"
    if low >= travel.period - EDGE:
        text = "never acts: its window begins at {begins}, but the motion ends at {last}"
    else:
        text = "has a window to {ends}, but the motion ends at {last}"
    yield Grade(severity, where, Phrase(text, begins=begins, ends=ends, last=last))


def _angles(positions: tuple[str, str], travel: Travel, where: str) -> tuple[float, float]:
    labels = travel.labels
    unknown = next((label for label in positions if label not in labels), None)
    if unknown is not None:
        raise NoSolutionError(
            f"there is no position {unknown!r}; the positions are 0 to {travel.names[-1]}",
            where=f"{where}, positions",
            remedy="name positions of the grid, or give angles: between = [...]",
        )
    return labels[positions[0]], labels[positions[1]]


def _within(theta: Real, low: float, high: float) -> Flags:
    """Whether theta lies in the closed window; one that ends before it begins goes over position 0."""
    after, before = theta >= low - EDGE, theta <= high + EDGE
    return after & before if low < high else after | before


def handed_over(travel: Travel, window: Inside, others: Sequence[Inside]) -> Callable[[Place], Any]:
    """Where a load acts if ``others`` of its kind act on the same link: where one ends another may begin.

    A position at which two windows meet would otherwise bear both loads, which no instant does: the limit before it
    has the load that ends, the one after it the load that begins.
    """
    ends = _shared(travel, window.ends, [b for other in others for b in other.begins])
    begins = _shared(travel, window.begins, [e for other in others for e in other.ends])
    if not ends.size and not begins.size:
        return window.inside

    def inside(place: Place) -> Flags:
        after = np.asarray(place.side) > 0
        over, early = _near(travel, place.theta, ends) & after, _near(travel, place.theta, begins) & ~after
        return np.logical_and(window.inside(place), ~(over | early))

    return inside


def _shared(travel: Travel, own: Sequence[float], others: Sequence[float]) -> Real:
    return np.array([a for a in own if _near(travel, np.array(a), np.array(others))])


def _near(travel: Travel, theta: Real, edges: Real) -> Flags:
    """Whether theta (n,) lies at one of the edges, of a cycle at its either end."""
    gap = np.abs(np.asarray(theta)[..., None] - edges)
    if travel.whole:
        gap = np.minimum(np.mod(gap, travel.period), travel.period - np.mod(gap, travel.period))
    return np.any(gap <= EDGE, axis=-1)
