"""Largest values of many functions on panels at once, to rounding where the panels resolve them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.numerics.panels import Panels, Values, rule

TERMS = 7  # of the Taylor polynomial: what is left out is less than 1e-10 between two points
NEWTON = 3


def peaks(on: Panels, values: Values) -> tuple[Values, Values]:
    """Largest value of every function (F, K, N) and its place, each (F,); limits at edges included.

    The highest point is refined by the Taylor polynomial there, whose terms the panel gives. `Panels.extremes` seeks
    all turning points of one function instead, which takes longer and finds the higher of two peaks between points.

    >>> from tmmcalc.numerics.panels import panels
    >>> on = panels(0.0, 3.0)
    >>> [round(float(x[0]), 12) for x in peaks(on, np.sin(on.x)[None])]
    [1.0, 1.570796326795]
    """
    r, functions = rule(on.order), np.arange(len(values))
    k, i = np.divmod(np.argmax(values.reshape(len(values), -1), axis=1), on.order)
    terms = _taylor(values[functions, k], r.slope, i)
    d = np.zeros(len(values))
    for _ in range(NEWTON):
        first = _horner([m * term for m, term in enumerate(terms)][1:], d)
        second = _horner([m * (m - 1) * term for m, term in enumerate(terms)][2:], d)
        move = np.where(second < 0, -first / np.where(second < 0, second, 1.0), 0.0)
        d = np.clip(d + move, -1 / on.order, 1 / on.order)
    t = np.clip(r.points[i] + d, 0.0, 1.0)
    low, high = on.ends(values)
    refined, point = _horner(terms, t - r.points[i]), values[functions, k, i]
    found = np.concatenate((refined[:, None], point[:, None], low, high), axis=1)
    inside = (on.edges[k] + np.stack((t, r.points[i])) * on.width[k]).T
    edges = np.broadcast_to(np.concatenate((on.edges[:-1], on.edges[1:])), (len(values), 2 * on.count))
    best = np.argmax(found, axis=1)
    return found[functions, best], np.concatenate((inside, edges), axis=1)[functions, best]


def _taylor(rows: Values, slope: Values, i: Values) -> list[Values]:
    """Terms (m,) each of the polynomials of rows (m, N) about their points ``i`` (m,)."""
    derivatives = [rows]
    for _ in range(TERMS):
        derivatives.append(derivatives[-1] @ slope.T)
    each = np.arange(len(rows))
    return [row[each, i] / math.factorial(m) for m, row in enumerate(derivatives)]


def _horner(terms: Sequence[Values], d: Values) -> Values:
    value = terms[-1]
    for term in reversed(terms[:-1]):
        value = value * d + term
    return value
