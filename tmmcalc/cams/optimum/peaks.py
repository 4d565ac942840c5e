"""Largest values of many functions at once: each is held by its values at Gauss points and both ends of panels.

A panel and its ends carry a polynomial; the largest value is that of its stationary point beside the largest of the
values, found by Newton's method, or of an end.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.numerics.panels import ORDER, rule

STEPS = 2  # of Newton's method after the first: the place is then good to 1e-8, the value to rounding
TERMS = 12  # of the series about a node: what is left out is less than what the panel leaves out
FEW = 100  # functions whose series are cheaper one by one
TINY = 1e-300


class Ended(NamedTuple):
    """Nodes of a panel [0, 1] with its ends, and the Taylor series about each of the polynomial through them."""

    points: Values  # (N + 2,)
    series: Values  # (N + 2, N + 2, TERMS) of node n: coefficients of d, d^2 and so on from the values


@cache
def ended(order: int = ORDER) -> Ended:
    """The nodes of ``order`` Gauss points and both ends."""
    t = np.concatenate(([0.0], rule(order).points, [1.0]))
    gap = t[:, None] - t + np.eye(len(t))
    barycentric = 1 / np.prod(4 * gap, axis=1)
    slope = barycentric / barycentric[:, None] / gap
    np.fill_diagonal(slope, 0.0)
    np.fill_diagonal(slope, -slope.sum(axis=1))
    power, terms = np.eye(len(t)), []
    for k in range(1, TERMS + 1):
        power = power @ slope / k
        terms.append(power)
    return Ended(t, np.ascontiguousarray(np.stack(terms).transpose(1, 2, 0)))


def largest(values: Values) -> Values:
    """Largest value (B,) of functions (B, K, N + 2) on K panels.

    >>> t = ended().points
    >>> float(largest((t * (1.3 - t))[None, None])[0].round(12))
    0.4225
    """
    return located(values)[0]


def located(values: Values) -> tuple[Values, Indices, Values]:
    """Largest values (B,) of functions (B, K, N + 2), the panels that have them, and where in [0, 1] of these."""
    rows, nodes = np.arange(len(values)), values.shape[-1]
    at = np.argmax(values.reshape(len(values), -1), axis=1)
    panel, node = at // nodes, at % nodes
    held = values[rows, panel]
    r, best = ended(nodes - 2), held[rows, node]
    place, slopes = r.points[node], np.einsum("mn,nm->m", held, r.series[node, :, 0].T)
    inner = np.flatnonzero(((node > 0) | (slopes > 0)) & ((node < nodes - 1) | (slopes < 0)))
    if not inner.size:
        return best, panel, place
    i = node[inner]
    grown, moved = _raised(_series(held[inner], i), r.points[np.maximum(i - 1, 0)] - place[inner],
                           r.points[np.minimum(i + 1, nodes - 1)] - place[inner])  # fmt: skip
    best[inner] += grown
    place[inner] += moved
    return best, panel, place


def _series(held: Values, node: Indices) -> Values:
    """Coefficients (m, TERMS) about a node (m,) of functions (m, N + 2); of many, those about one node at once."""
    series, found = ended(held.shape[1] - 2).series, np.empty((len(held), TERMS))
    if len(held) < FEW:
        return np.matmul(held[:, None], series[node])[:, 0]
    order = np.argsort(node, kind="stable")
    ends = np.searchsorted(node[order], np.arange(len(series) + 1))
    for k in np.flatnonzero(np.diff(ends)).tolist():
        rows = order[ends[k] : ends[k + 1]]
        found[rows] = held[rows] @ series[k]
    return found


def _raised(series: Values, low: Values, high: Values) -> tuple[Values, Values]:
    """By how much (m,) the stationary points between ``low`` and ``high`` are above the nodes, and how far away."""
    first = series * np.arange(1, TERMS + 1)
    second = first[:, 1:] * np.arange(1, TERMS)
    slope, bend = first[:, 0], second[:, 0]
    d = np.zeros(len(series))
    for step in range(STEPS + 1):
        if step:
            power = _powers(d)
            slope = first[:, 0] + np.einsum("mk,mk->m", first[:, 1:], power[:, :-1])
            bend = second[:, 0] + np.einsum("mk,mk->m", second[:, 1:], power[:, :-2])
        d = np.clip(d - slope / np.where(bend < 0, bend, -np.abs(bend) - TINY), low, high)
    grown = np.einsum("mk,mk->m", series, _powers(d))
    better = grown > 0
    return np.where(better, grown, 0.0), np.where(better, d, 0.0)


def _powers(d: Values) -> Values:
    """d, d^2 and so on (m, TERMS)."""
    found: Values = np.multiply.accumulate(np.repeat(d[:, None], TERMS, axis=1), axis=1)
    return found
