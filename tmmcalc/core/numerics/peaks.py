"""Largest values of many functions on panels at once, to rounding where the panels resolve them."""

from __future__ import annotations

from functools import cache

import numpy as np

from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.panels import Panels, Values

TERMS = 7  # of the Taylor polynomial: what is left out is less than 1e-10 between two points
NEWTON = 3
_DEGREES = np.arange(TERMS + 1.0)[:, None]
_FIRST, _SECOND = _DEGREES[1:], (_DEGREES * (_DEGREES - 1))[2:]  # factors of the terms in the derivatives


def peaks(on: Panels, values: Values) -> tuple[Values, Values]:
    """Largest value of every function (F, K, N) and its place, each (F,); limits at edges included.

    The highest point is refined by the Taylor polynomial there, whose terms the panel gives. `Panels.extremes` seeks
    all turning points of one function instead, which takes longer and finds the higher of two peaks between points.

    >>> from tmmcalc.core.numerics.panels import panels
    >>> on = panels(0.0, 3.0)
    >>> [round(float(x[0]), 12) for x in peaks(on, np.sin(on.x)[None])]
    [1.0, 1.570796326795]
    """
    r, functions = rule(on.order), np.arange(len(values))
    k, i = np.divmod(np.argmax(values.reshape(len(values), -1), axis=1), on.order)
    terms = (_taylor(on.order)[i] @ values[functions, k][:, :, None])[:, :, 0].T
    d = np.zeros(len(values))
    for _ in range(NEWTON):
        powers = d**_DEGREES
        first = np.add.reduce(_FIRST * terms[1:] * powers[:-1])
        second = np.add.reduce(_SECOND * terms[2:] * powers[:-2])
        move = np.where(second < 0, -first / np.where(second < 0, second, 1.0), 0.0)
        d = np.clip(d + move, -1 / on.order, 1 / on.order)
    t = np.clip(r.points[i] + d, 0.0, 1.0)
    low, high = on.ends(values)
    refined, point = np.add.reduce(terms * (t - r.points[i]) ** _DEGREES), values[functions, k, i]
    found = np.concatenate((refined[:, None], point[:, None], low, high), axis=1)
    inside = (on.edges[k] + np.stack((t, r.points[i])) * on.width[k]).T
    edges = np.broadcast_to(np.concatenate((on.edges[:-1], on.edges[1:])), (len(values), 2 * on.count))
    best = np.argmax(found, axis=1)
    return found[functions, best], np.concatenate((inside, edges), axis=1)[functions, best]


@cache
def _taylor(order: int) -> Values:
    """What gives the terms of the polynomial about each point of a panel from its values, (N, TERMS + 1, N)."""
    slope, rows = rule(order).slope, [np.eye(order)]
    for m in range(1, TERMS + 1):
        rows.append(slope @ rows[-1] / m)
    return np.stack(rows, axis=1)
