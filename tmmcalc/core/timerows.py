"""Rows of a table in time whose accelerations jump, and extremes of what moves between the jumps.

The rows stand at equal steps t_j = j T/n and at every instant of a jump. A jump inside the motion has two rows, one for
each side; the first and the last row are the limits inside the motion.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from tmmcalc.core.numerics.gauss import Rule, rule
from tmmcalc.core.numerics.panels import Panels, Values, panels, resolved
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

SAME = 1e-12  # of the duration: instants nearer than this are one
PARTS = 12  # panels of the duration to begin with
CLOSEST = 2  # panels with the largest samples are searched for the extreme between them
NEWTON = 6  # steps to it
RESOLVED = 1e-11  # of the largest value: what the panels may leave out
LEVEL = 1e-12  # of the largest value: smaller differences are rounding
STILL = 1e-12  # of what a quantity is made from: one that is never more is zero but for rounding
FLAT = 1e-6  # of the duration: where a quantity is level, its largest value stands as uncertain as sqrt(LEVEL)


@record
class TimeRows:
    """Instants of a table, each on one side of what jumps there."""

    t: Values  # (n,) [s]
    side: Indices  # (n,) -1: the limit from before, +1: from after
    labels: tuple[str, ...]  # number of the step; 3' comes after step 3, 3'- is the limit before a jump at 3'


@record
class TimedExtreme:
    """The smallest and the largest value of a quantity over the motion, and when they are reached."""

    name: str
    unit: str
    least: float = quantity("{name}_min[{unit}]", "smallest {name}")
    least_at: float = quantity("{name}_min_at[s]", "time of the smallest {name}")
    largest: float = quantity("{name}_max[{unit}]", "largest {name}")
    largest_at: float = quantity("{name}_max_at[s]", "time of the largest {name}")

    @property
    def size(self) -> tuple[float, float]:
        """The value of the largest size, and its time [s]."""
        low = abs(self.least) > abs(self.largest)
        return (self.least, self.least_at) if low else (self.largest, self.largest_at)


def time_rows(duration: float, steps: int, jumps: Sequence[float], knots: Sequence[float] = ()) -> TimeRows:
    """The rows of ``steps`` equal steps of the duration [s], of the jumps, and of knots, where nothing jumps.

    Without a duration there is one row.

    >>> time_rows(4.0, 2, (0.0, 1.0, 3.0, 4.0)).labels
    ('0', "0'-", "0'", '1', "1'-", "1'", '2')
    >>> time_rows(4.0, 2, (), (1.0, 2.0)).labels
    ('0', "0'", '1', '2')
    """
    if not duration:
        return TimeRows(np.zeros(1), np.ones(1, int), ("0",))
    equal = np.linspace(0.0, duration, steps + 1)
    labels = list(map(str, range(steps + 1)))
    marked = sorted([(jump, (-1, 1)) for jump in jumps] + [(knot, (1,)) for knot in knots])
    added = _added(equal, [mark for mark in marked if SAME * duration < mark[0] < duration * (1 - SAME)])
    places = [place for place, *_ in added]
    t = np.insert(equal, places, [instant for _, instant, _, _ in added])
    side = np.insert(np.append(np.ones(steps, int), -1), places, [side for _, _, side, _ in added])
    for place, _, _, label in reversed(added):
        labels.insert(place, label)
    return TimeRows(t, side, tuple(labels))


def _added(equal: Values, marked: Sequence[tuple[float, tuple[int, ...]]]) -> list[tuple[int, float, int, str]]:
    """Rows that instants with their sides add before a step: its number, time, side, label.

    A step within rounding of an instant becomes the instant, and is itself the row after it.
    """
    found: list[tuple[int, float, int, str]] = []
    further: dict[int, int] = {}
    for instant, sides in marked:
        k = int(np.argmin(np.abs(equal - instant)))
        if abs(equal[k] - instant) <= SAME * equal[-1]:
            equal[k] = instant
            label, sides = str(k), sides[:-1]
        else:
            k = int(np.searchsorted(equal, instant))
            further[k] = further.get(k, 0) + 1
            label = f"{k - 1}{further[k] * chr(39)}"
        found += [(k, instant, side, f"{label}-" if side < 0 else label) for side in sides]
    return found


def over_time(duration: float, breaks: Sequence[float]) -> Panels:
    """Panels of the duration [s] with edges at all breaks; the duration is above zero."""
    return panels(0.0, duration, breaks, duration / PARTS)


def extremes(
    f: Callable[[Values], Values],
    duration: float,
    breaks: Sequence[float],
    names: Sequence[tuple[str, str]],
    peers: Values | None = None,
) -> tuple[TimedExtreme, ...]:
    """Extremes of F functions, ``f(t (m,)) -> (F, m)``, that are smooth between the breaks; ``names`` with units.

    Both limits count where something jumps. f is never asked for the instant of a break. ``peers`` (F,) are the sizes
    of what the functions are made from: one that is never more than rounding beside them is zero.
    """
    if not duration:
        return ()
    first = over_time(duration, breaks)
    if peers is not None:
        still = np.max(np.abs(f(first.x.ravel())), axis=1) <= STILL * peers
        on, values, _ = resolved(lambda t: np.where(still[:, None], 0.0, f(t)), first, RESOLVED)
    else:
        on, values, _ = resolved(f, first, RESOLVED)
    least, largest = (_most(on, sign * values) for sign in (-1, 1))
    return tuple(
        TimedExtreme(name, unit, 0.0 - low, low_at, high + 0.0, high_at)
        for (name, unit), (low, low_at), (high, high_at) in zip(names, least, largest, strict=True)
    )


def _most(on: Panels, values: Values) -> list[tuple[float, float]]:
    """The largest value of each function (F, K, N) and where it is; of equal ones the first, and noise is zero.

    Where a peak and a break cannot be told apart it is the break: the end of the motion, not a rounding before it.
    """
    low, high = on.ends(values)
    inner, inner_at = _peaks(on, values)
    value = np.concatenate((low, high, inner), axis=1)
    at = np.concatenate((*(np.broadcast_to(e, low.shape) for e in (on.edges[:-1], on.edges[1:])), inner_at), axis=1)
    level = LEVEL * np.max(np.abs(value), axis=1, keepdims=True)
    value = np.where(np.abs(value) <= level, 0.0, value)
    equal = value >= np.max(value, axis=1, keepdims=True) - level
    late = np.repeat((0.0, FLAT * (on.edges[-1] - on.edges[0])), (2 * low.shape[1], inner.shape[1]))
    first = np.argmin(np.where(equal, at + late, np.inf), axis=1)[:, None]
    pairs = (np.take_along_axis(each, first, axis=1)[:, 0].tolist() for each in (value, at))
    return list(zip(*pairs, strict=True))


def _peaks(on: Panels, values: Values) -> tuple[Values, Values]:
    """Values and places (F, C) of the maxima inside the panels with the largest samples, by Newton from these."""
    functions, nodes = np.arange(len(values))[:, None], rule(on.order)
    panel = np.argsort(np.max(values, axis=2), axis=1)[:, -CLOSEST:]
    slopes = on.slope(values)
    rows, first, second = (each[functions, panel] for each in (values, slopes, on.slope(slopes)))
    points = np.concatenate(([0.0], nodes.points, [1.0]))
    best = np.argmax(rows, axis=2)
    t, left, right = points[best + 1], points[best], points[best + 2]
    width = on.width[panel]
    for _ in range(NEWTON):
        part = _weights(t, nodes)
        slope, bend = ((part * each).sum(axis=2) for each in (first, second))
        step = np.where(bend < 0, slope / np.where(bend < 0, bend, 1.0), 0.0) / width
        t = np.minimum(np.maximum(t - step, left), right)
    found = (_weights(t, nodes) * rows).sum(axis=2)
    kept = found >= rows.max(axis=2)
    t = np.where(kept, t, points[best + 1])
    return np.where(kept, found, rows.max(axis=2)), on.edges[panel] + width * t


def _weights(t: Values, nodes: Rule) -> Values:
    """Weights (..., N) that interpolate values at the nodes of a panel at its parts t (...)."""
    gap = t[..., None] - nodes.points
    hit = gap == 0
    part = np.where(hit.any(axis=-1, keepdims=True), hit, nodes.barycentric / np.where(hit, 1.0, gap))
    return np.asarray(part / part.sum(axis=-1, keepdims=True))
