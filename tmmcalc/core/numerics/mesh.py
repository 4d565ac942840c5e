"""A mesh of panels for functions of one or of several variants, which is cut where they are not resolved yet.

Every variant has as many panels as it needs; those of a variant stand one behind the other. Values have the shape
(..., P, N): P panels of N Gauss points. What is found is handed on as the `Panels` of each variant.
"""

from __future__ import annotations

from collections.abc import Collection
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.panels import NARROWEST, Panels, Values
from tmmcalc.core.numerics.roots import Indices

Flags = NDArray[np.bool_]

SLIVER = 1e-6  # part of the range: an edge so near to a place may be what it was put for, by a guess
SAME = 1e-9  # part of the range: an edge so near to a place stands at it


class Mesh(NamedTuple):
    """P panels: the variant that each belongs to, ascending from 0, and its ends."""

    owner: Indices  # (P,)
    low: Values  # (P,)
    high: Values  # (P,)

    @property
    def width(self) -> Values:
        """Widths (P,)."""
        return self.high - self.low

    @property
    def x(self) -> Values:
        """The Gauss points (P, N)."""
        return self.low[:, None] + self.width[:, None] * rule(ORDER).points

    def at(self, which: Indices | Flags) -> Mesh:
        """Some of the panels."""
        return Mesh(self.owner[which], self.low[which], self.high[which])

    def largest(self, values: Values) -> Values:
        """Largest value (..., V) of all panels (..., P) of every variant."""
        return np.asarray(np.maximum.reduceat(values, np.flatnonzero(_begin(self.owner)), axis=-1))

    def panels_of(self, variant: int) -> tuple[Panels, slice]:
        """The panels of one variant, and their numbers."""
        low, high = np.searchsorted(self.owner, (variant, variant + 1)).tolist()
        return Panels(np.append(self.low[low:high], self.high[high - 1])), slice(low, high)

    def halved(self, which: Flags) -> Cut:
        """The mesh with the panels of ``which`` (P,) halved."""
        panel = np.flatnonzero(which)
        return _inserted(self, panel, (self.low[panel] + self.high[panel]) / 2)

    def cut(self, panel: Indices, place: Values, period: float) -> Cut:
        """The mesh cut at places (m,) within ``panel`` (m,), but for places at an edge or at another place.

        What is near to another place is another kink, and gets its own edge.
        """
        order = np.lexsort((place, panel))
        panel, place = panel[order], place[order]
        apart = (place - self.low[panel] > SLIVER * period) & (self.high[panel] - place > SLIVER * period)
        panel, place = panel[apart], place[apart]
        apart = _begin(panel) | (place - np.roll(place, 1) > SAME * period)
        return _inserted(self, panel[apart], place[apart])

    def cut_or_moved(self, places: Values, period: float, fixed: Collection[float]) -> Cut:
        """The mesh of one variant cut at places (m,); edges that are not ``fixed`` move to a place near to them.

        Most were put for it, by a guess.
        """
        old = [*self.low.tolist(), float(self.high[-1])]
        edges = list(old)
        held, taken = {old[0], old[-1], *fixed}, set[float]()
        for place in sorted(places.tolist()):
            k = int(np.searchsorted(edges, place))
            near = k if edges[k] - place < place - edges[k - 1] else k - 1
            gap = abs(edges[near] - place)
            apart = SAME if edges[near] in taken else SLIVER
            if gap > apart * period:
                edges.insert(k, place)
            elif gap > SAME * period and edges[near] not in held:
                edges[near] = place
            else:
                place = edges[near]
            taken.add(place)
        numbers = {pair: k for k, pair in enumerate(pairwise(old))}
        source = np.array([numbers.get(pair, -1) for pair in pairwise(edges)])
        at = np.array(edges)
        return Cut(Mesh(np.zeros(len(source), np.intp), at[:-1], at[1:]), source < 0, source[source >= 0])


class Cut(NamedTuple):
    """A mesh some of whose panels are cut: which are ``fresh`` (P,), and of the others the numbers they had before."""

    mesh: Mesh
    fresh: Flags
    source: Indices

    @property
    def new(self) -> Mesh:
        """The fresh panels alone."""
        return self.mesh.at(self.fresh)

    def merged(self, old: Any, new: Any) -> Any:
        """Values (..., P, N) on all panels from those on the old ones and on the fresh ones."""
        result = np.empty((*old.shape[:-2], len(self.fresh), old.shape[-1]), old.dtype)
        result[..., self.fresh, :] = new
        result[..., ~self.fresh, :] = old[..., self.source, :]
        return result


def laid(period: float, breaks: Values, widest: float) -> Mesh:
    """Panels of [0, period] for V variants with an edge at every break (V, B) inside, none wider than ``widest``.

    Breaks nearer to each other than the narrowest panel count as one.
    """
    least = NARROWEST * period
    edges = np.empty((len(breaks), breaks.shape[1] + 2))
    edges[:, 0], edges[:, 1:-1], edges[:, -1] = 0.0, np.sort(breaks, axis=1), period
    edges[edges > period - least] = period
    apart = edges[:, 1:] - edges[:, :-1] > least
    edges[:, 1:] = np.maximum.accumulate(np.where(apart, edges[:, 1:], 0.0), axis=1)  # an edge nearer than that is lost
    width = edges[:, 1:] - edges[:, :-1]
    parts = np.ceil(width / widest - 1e-9).astype(int)
    count, step = parts.ravel(), (width / np.maximum(parts, 1)).ravel()
    before = count.cumsum() - count
    low = edges[:, :-1].ravel().repeat(count) + step.repeat(count) * (np.arange(count.sum()) - before.repeat(count))
    high = np.append(low[1:], 0.0)
    high[high == 0.0] = period
    return Mesh(np.arange(len(breaks)).repeat(parts.sum(axis=1)), low, high)


def _inserted(mesh: Mesh, panel: Indices, place: Values) -> Cut:
    """The mesh with an edge at every place (m,) within ``panel`` (m,), ascending."""
    begin, end = _begin(panel), np.roll(_begin(panel), -1)
    parents = panel[begin]
    low = np.concatenate((mesh.low[parents], place))
    high = np.concatenate((place[begin], np.where(end, mesh.high[panel], np.roll(place, -1))))
    owner = mesh.owner[np.concatenate((parents, panel))]
    stays = np.ones(len(mesh.owner), bool)
    stays[parents] = False
    kept = np.flatnonzero(stays)
    joined = Mesh(*(np.concatenate(pair) for pair in zip(mesh.at(kept), (owner, low, high), strict=True)))
    order = np.lexsort((joined.low, joined.owner))
    return Cut(joined.at(order), order >= len(kept), kept[order[order < len(kept)]])


def _begin(owner: Indices) -> Flags:
    """Which of ascending numbers (m,) differ from the one before; the first does."""
    return np.concatenate((np.ones(min(len(owner), 1), bool), owner[1:] != owner[:-1]))
