"""Extremes of a function that is known at n positions alone, as a table on paper gives them; and their reference.

The largest value is sought by brute force: of many nodes the best, and ever finer ones about it. The place that the
judged method names is closed in on as well, for a value that is reached anywhere bounds the largest from below; so a
method that misses it is told by the nodes, and the nodes by it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.studies.measure import Clock, Way, series
from tmmcalc.core.studies.study import Series

# Positions of a cycle. The later ones hold few of those before them, so that an extreme on a position by chance shows.
COUNTS = (12, 24, 48, 97, 193, 389, 769, 1543)
SECOND = "of order 2 on the whole: how near to the extreme a position happens to stand; of order 1 where it jumps"
BESIDE = 1e-9  # [rad or m] of an end of a load or of a piece of a law: both sides are meant
NODES = 4001
ZOOMS = 16  # rounds about the best node, each with a step an eighth of that before
ABOUT = np.arange(-12, 13) / 8  # nodes of a round, in steps of the round before: one and a half to both sides


class Summit(NamedTuple):
    """Largest values (F,) of functions, and the most that the nodes alone fall short of one, relative to it."""

    values: Real
    short: float


def of_positions(
    method: str, ways: Iterable[Way], error: Callable[[Any], float], clock: Clock, note: str = SECOND
) -> Series:
    """A series of numbers of positions: of order 2 by theory, of which chance lets none be observed."""
    return series(method, ways, error, clock, expected=2.0, note=note, stepwise=False)


def summit(of: Callable[[Real], Real], period: float, named: Sequence[float]) -> Summit:
    """Largest values of functions ``of(x) -> (F, m)`` over [0, period], where a method names the places (F,).

    The functions are asked beyond both ends too, by a few thousandths of the period, and in extended precision.
    """
    step = period / (NODES - 1)
    nodes = step * np.arange(NODES)
    own = closed_in(of, nodes[np.argmax(of(nodes), axis=1)], step)
    values = np.maximum(own, closed_in(of, np.array(named, float), step))
    some = values != 0
    return Summit(values, float(np.max((values - own)[some] / np.abs(values)[some], initial=0.0)))


def closed_in(of: Callable[[Real], Real], places: Real, step: float) -> Real:
    """The largest values (F,) that ever finer nodes about the places (F,), a place a function, come to."""
    every, at, width = np.arange(len(places)), places.astype(np.longdouble), np.longdouble(step)
    best = of(at)[every, every]
    for _ in range(ZOOMS):
        nodes = at[:, None] + width * ABOUT
        values = of(nodes.ravel()).reshape(len(places), *nodes.shape)[every, every]
        best = np.maximum(best, np.max(values, axis=1))
        at, width = nodes[every, np.argmax(values, axis=1)], width / 8
    return best


def on_edges(x: Real, edges: Real) -> Real:
    """x (m,), set on an edge where one is near: loads and laws reach a little beyond their ends, where nothing is."""
    nearest = edges[np.argmin(np.abs(x[:, None] - edges), axis=1)]
    return np.where(np.abs(x - nearest) < 2 * BESIDE, nearest, x)
