"""Zeros of periodic functions of many variants at once, as long as they are simple and apart."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Real

Flags = NDArray[np.bool_]
Rates = Callable[[Real, Indices, Indices], Real]
"""(places, numbers of the variants, numbers of the functions), each (m,) -> values (m,)."""

NEAR = 0.02  # of the largest value: a turning point so near to zero may hide two zeros
REST = 1e-9  # of the scale: a function below it is rest


class Zeros(NamedTuple):
    """Zeros of every function, (V, count) each, ascending; and which variants are like the most of them and clear."""

    places: tuple[Real, ...]
    clear: Flags


def zeros(f: Rates, x: Real, values: Real, scales: Real, first: int | None = None) -> Zeros:
    """All zeros of periodic functions from their samples (F, V, n) at the equal steps ``x`` (n,); scales (F, V).

    ``first`` is how many the first function has to have, None: as many as that of the most variants.
    """
    cells, clear = _cells(values, scales)
    counts = cells.sum(axis=2)
    if first is not None:
        clear &= counts[0] == first
    usual = np.array([np.bincount(row[clear]).argmax() if clear.any() else 0 for row in counts])
    clear &= np.all(counts == usual[:, None], axis=0)
    function, variant, cell = np.nonzero(cells & clear[:, None])
    after = np.roll(values, -1, axis=2)
    low, high = values[function, variant, cell], after[function, variant, cell]
    step = x[1] - x[0]
    guess = x[cell] + step * low / np.where(low == high, 1.0, low - high)
    found = bracketed(
        lambda at, which: f(at, variant[which], function[which]), x[cell], x[cell] + step, known=(low, high, guess)
    )
    places = []
    for k, count in enumerate(usual.tolist()):
        own = np.zeros((values.shape[1], count))
        own[clear] = found[function == k].reshape(np.count_nonzero(clear), count)
        places.append(own)
    return Zeros(tuple(places), clear)


def _cells(values: Real, scales: Real) -> tuple[Flags, Flags]:
    """The steps (F, V, n) in which a function changes its sign, and the variants (V,) that hide no further zeros."""
    before, after = np.roll(values, 1, axis=2), np.roll(values, -1, axis=2)
    negative = np.signbit(values)
    change = negative != np.signbit(after)
    size = np.abs(values)
    largest = np.max(size, axis=2)
    turns = (size <= np.abs(before)) & (size <= np.abs(after)) & ~change & ~np.roll(change, 1, axis=2)
    bound = np.maximum(np.abs(values - before), np.abs(after - values))
    hides = turns & (size < np.maximum(bound, NEAR * largest[:, :, None]))
    return change, np.all((largest > REST * scales) & ~hides.any(axis=2), axis=0)
