"""Largest values of many functions at once: each is held by its values at Gauss points and both ends of panels.

A panel and its ends carry a polynomial; the largest value is that of its stationary point beside the largest of the
values, found by Newton's method, or of an end.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.core.numerics.gauss import ORDER, rule

TERMS = 12  # of the series about a node: what is left out is less than what the panel leaves out
STEPS = (
    6,
    TERMS,
)  # of the series in Newton's steps after the first: the place is then good to 1e-8, the value to rounding
ORDERS = np.arange(1.0, TERMS + 1)
FEW = 100  # functions whose series are cheaper one by one
MANY = 1000  # functions at a time: their series then stay in the cache
TINY = 1e-300
RISE = 0.02  # of what a function varies by on a panel: a crest is no further above the highest node (parabola: 0.009)
SAME = 1e-12  # values of neighbouring panels at their edge that are one


class Ended(NamedTuple):
    """Nodes of a panel [0, 1] with its ends, and the Taylor series about each of the polynomial through them."""

    points: Values  # (N + 2,)
    slope: Values  # (N + 2, N + 2) derivative at each node
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
    return Ended(t, slope, np.ascontiguousarray(np.stack(terms).transpose(1, 2, 0)))


class Crest(NamedTuple):
    """Where B functions are largest among their nodes, in the panel in which they may rise above."""

    held: Values  # (B, N + 2) values on the panel
    panel: Indices  # (B,)
    node: Indices  # (B,) in the panel
    rises: Mask  # (B,) whether there is something higher beside the node


def crest(values: Values) -> Crest:
    """The crests of functions (B, K, N + 2) on K panels; the last goes on in the first."""
    row, highest = np.arange(len(values)), np.max(values, axis=2)
    panel = np.argmax(highest, axis=1)
    node = np.argmax(values[row, panel], axis=1)
    found, (rows, panels, tops) = _begun(values, row, panel, node), _rivals(values, highest, panel)
    if not rows.size:
        return found
    each = rows[np.append(True, rows[1:] != rows[:-1])]  # np.unique imports the masked arrays
    rows, panels, tops = (np.append(old[each], new) for old, new in ((row, rows), (panel, panels), (node, tops)))
    high, _ = peak(_begun(values, rows, panels, tops))
    order = np.lexsort((high, rows))
    best = order[np.append(rows[order][1:] != rows[order][:-1], True)]
    panel[each], node[each] = panels[best], tops[best]
    return _begun(values, row, panel, node)


def _rivals(values: Values, tops: Values, panel: Indices) -> tuple[Indices, Indices, Indices]:
    """Function, panel and node (m,) of crests that may rise above the highest nodes.

    ``tops`` (B, K) are the highest values of every panel, ``panel`` (B,) that of the highest of all.
    """
    count, panels, nodes = values.shape
    top = tops[np.arange(count), panel]
    near = tops >= (top - RISE * (top - np.min(values, axis=(1, 2))))[:, None]
    near[np.arange(count), panel] = False
    rows, others = np.nonzero(near)
    held = values[rows, others]
    at, high = np.argmax(held, axis=1), tops[rows, others]
    beside = np.argmax(values[rows, (others + 1) % panels], axis=1) == 0
    inside = ((at > 0) & (at < nodes - 1)) | ((at == nodes - 1) & beside)
    rise = RISE * (high - np.min(held, axis=1))
    able = inside & (rise > SAME * np.abs(high)) & (high + rise >= top[rows])
    return rows[able], others[able], at[able]


def _begun(values: Values, row: Indices, panel: Indices, node: Indices) -> Crest:
    """The crests of functions ``row`` at nodes of panels, each (m,).

    A function that rises beyond a panel goes on in the next one, unless it jumps between them.
    """
    _, panels, nodes = values.shape
    panel, node = panel.copy(), node.copy()
    held, rises = values[row, panel], np.ones(len(row), bool)
    ends = np.flatnonzero((node == 0) | (node == nodes - 1))
    at = node[ends]
    way, other = np.where(at > 0, 1, -1), nodes - 1 - at
    slope = np.einsum("mn,mn->m", held[ends], ended(nodes - 2).slope[at]) * way
    beside = (panel[ends] + way) % panels
    here, there = held[ends, at], values[row[ends], beside, other]
    on = (slope > 0) & (np.abs(there - here) <= SAME * np.abs(here))
    rises[ends] = on | (slope < 0)
    moved = ends[on]
    panel[moved], node[moved], held[moved] = beside[on], other[on], values[row[moved], beside[on]]
    return Crest(held, panel, node, rises)


def largest(values: Values) -> Values:
    """Largest value (B,) of functions (B, K, N + 2) on K panels.

    >>> t = ended().points
    >>> float(largest((t * (1.3 - t))[None, None])[0].round(12))
    0.4225
    """
    return peak(crest(values))[0]


def peak(found: Crest) -> tuple[Values, Values]:
    """Largest values (B,) of functions, and where in [0, 1] of their panels."""
    r = ended(found.held.shape[1] - 2)
    best, place = found.held[np.arange(len(found.node)), found.node], r.points[found.node]
    rises = np.flatnonzero(found.rises)
    rises = rises[np.argsort(found.node[rises], kind="stable")]
    for part in range(0, len(rises), MANY):
        rows = rises[part : part + MANY]
        node = found.node[rows]
        low, high = r.points[np.maximum(node - 1, 0)], r.points[np.minimum(node + 1, len(r.points) - 1)]
        grown, moved = _raised(_series(found.held[rows], node), low - r.points[node], high - r.points[node])
        best[rows] += grown
        place[rows] += moved
    return best, place


def _series(held: Values, node: Indices) -> Values:
    """Coefficients (TERMS, m) about ascending nodes (m,) of functions (m, N + 2); of many, those about one at once."""
    series = ended(held.shape[1] - 2).series
    if len(held) < FEW:
        return np.einsum("mn,mnk->km", held, series[node])
    ends, found = np.searchsorted(node, np.arange(len(series) + 1)), np.empty((TERMS, len(held)))
    for k in np.flatnonzero(np.diff(ends)).tolist():
        part = slice(ends[k], ends[k + 1])
        np.matmul(series[k].T, held[part].T, out=found[:, part])
    return found


def _raised(series: Values, low: Values, high: Values) -> tuple[Values, Values]:
    """By how much (m,) the stationary points between ``low`` and ``high`` are above the nodes, and how far away."""
    first = series * ORDERS[:, None]
    second = first[1:] * ORDERS[:-1, None]
    slope, bend = first[0], second[0]
    d = np.zeros(series.shape[1])
    for terms in (1, *STEPS):
        if terms > 1:
            power = _powers(d, terms - 1)
            slope = first[0] + np.einsum("km,km->m", first[1:terms], power)
            bend = second[0] + np.einsum("km,km->m", second[1 : terms - 1], power[:-1])
        d = np.clip(d - slope / np.where(bend < 0, bend, -np.abs(bend) - TINY), low, high)
    grown = np.einsum("km,km->m", series, _powers(d, TERMS))
    better = grown > 0
    return np.where(better, grown, 0.0), np.where(better, d, 0.0)


def _powers(d: Values, terms: int) -> Values:
    """d, d^2 and so on (terms, m)."""
    found = np.empty((terms, len(d)))
    found[0], done = d, 1
    while done < terms:
        more = min(done, terms - done)
        np.multiply(found[:more], found[done - 1], out=found[done : done + more])
        done += more
    return found
