"""Panels of many variants, of each as many as it needs: those of a variant stand one behind the other."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.panels import NARROWEST
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.stacked.zeros import Flags


class Ragged(NamedTuple):
    """P panels: the variant that each belongs to, ascending, and its ends."""

    owner: Indices  # (P,)
    low: Real  # (P,)
    high: Real  # (P,)

    @property
    def width(self) -> Real:
        """Widths (P,)."""
        return self.high - self.low

    @property
    def x(self) -> Real:
        """The Gauss points (P, N)."""
        return self.low[:, None] + self.width[:, None] * rule(ORDER).points

    def at(self, which: Indices | Flags) -> Ragged:
        """Some of the panels."""
        return Ragged(self.owner[which], self.low[which], self.high[which])


def largest_of_owners(on: Ragged, values: Real) -> Real:
    """Largest value (..., V) of all panels (..., P) of every variant."""
    return np.asarray(np.maximum.reduceat(values, firsts(on), axis=-1))


def firsts(on: Ragged) -> Indices:
    """Number of the first panel of every variant (V,)."""
    return np.flatnonzero(np.append(True, on.owner[1:] != on.owner[:-1]))


def first(period: float, breaks: Real, widest: float) -> Ragged:
    """Panels of [0, period] for V variants with an edge at every break (V, B) inside, none wider than ``widest``.

    Breaks nearer to each other than the narrowest panel count as one.
    """
    least, count = NARROWEST * period, len(breaks)
    edges = np.concatenate((np.zeros((count, 1)), np.sort(breaks, axis=1), np.full((count, 1), period)), axis=1)
    edges[edges > period - least] = period
    for k in range(1, edges.shape[1]):
        near = edges[:, k] - edges[:, k - 1] <= least
        edges[near, k] = edges[near, k - 1]
    width = np.diff(edges, axis=1)
    parts = np.ceil(width / widest - 1e-9).astype(int)
    piece = np.repeat(np.arange(parts.size), parts.ravel())
    number = np.arange(len(piece)) - np.repeat(np.cumsum(parts) - parts.ravel(), parts.ravel())
    start, step = edges[:, :-1].ravel()[piece], (width / np.maximum(parts, 1)).ravel()[piece]
    low = start + step * number
    high = np.where(number + 1 == parts.ravel()[piece], edges[:, 1:].ravel()[piece], start + step * (number + 1))
    return Ragged(piece // parts.shape[1], low, high)


class Cut(NamedTuple):
    """Panels with some cut: which are ``fresh`` (P,), and of the others the numbers they had before."""

    panels: Ragged
    fresh: Flags
    source: Indices

    def merged(self, old: Any, new: Any) -> Any:
        """Values (..., P, N) on all panels from those on the old ones and on the fresh ones."""
        result = np.empty((*old.shape[:-2], len(self.fresh), old.shape[-1]), old.dtype)
        result[..., self.fresh, :] = new
        result[..., ~self.fresh, :] = old[..., self.source, :]
        return result


def cut(panels: Ragged, panel: Indices, place: Real, least: float) -> Cut:
    """The panels cut at places (m,) within ``panel`` (m,), but for places at an end or at another place."""
    order = np.lexsort((place, panel))
    panel, place = panel[order], place[order]
    before = np.where(np.append(True, panel[1:] != panel[:-1]), panels.low[panel], np.append(0.0, place[:-1]))
    keep = (place - before > least) & (panels.high[panel] - place > least)
    panel, place = panel[keep], place[keep]
    last = np.append(panel[1:] != panel[:-1], True) if len(panel) else np.zeros(0, bool)
    parents = panel[last]
    low = np.concatenate((panels.low[parents], place))
    high = np.concatenate(
        (
            place[np.append(True, last[:-1])] if len(panel) else place,
            np.where(last, panels.high[panel], np.append(place[1:], 0.0)[: len(place)]),
        )
    )
    owner = panels.owner[np.concatenate((parents, panel))]
    stays = np.ones(len(panels.owner), bool)
    stays[parents] = False
    kept = np.flatnonzero(stays)
    joined = Ragged(*(np.concatenate(pair) for pair in zip(panels.at(kept), (owner, low, high), strict=True)))
    order = np.lexsort((joined.low, joined.owner))
    return Cut(joined.at(order), order >= len(kept), kept[order[order < len(kept)]])
