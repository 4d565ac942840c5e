"""The Pareto front: variants that no other one betters in every respect.

a dominates b if a_k <= b_k for all k and a_k < b_k for one; equal variants do not dominate each other. All
comparisons are exact. In lexicographic order whatever dominates a variant stands before it, so the front of the
first half is settled without the second, and of the front of the second half those fall that the first dominates in
the remaining criteria. Halving by these in turn leads to two criteria, where one sorted pass answers for all
variants: O(n log n) for two criteria, O(n log^(k-2) n) for k > 2, however large the front (Kung, Luccio, Preparata,
J. ACM 22 (1975) 469).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.model import Values

SMALL = 128  # rows among which all pairs are compared
PAIRS = 1 << 17  # of rows of two groups that are all compared
SIEVE = 32  # good rows that all others are compared with first

Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]


def pareto_front(values: Values) -> Indices:
    """Indices, ascending, of the rows of ``values`` (n, k) that no other row dominates; less is better.

    Raises `UsageError` for values that are not finite or without a criterion.

    >>> pareto_front(np.array([[1.0, 4.0], [2.0, 2.0], [2.0, 3.0], [3.0, 1.0], [2.0, 2.0]])).tolist()
    [0, 1, 3, 4]
    """
    if values.ndim != 2 or not values.shape[1] or not np.all(np.isfinite(values)):
        text = f"values of shape {values.shape}"
        raise UsageError(text, where="Pareto front", remedy="finite values (n, k), one criterion or more")
    if not len(values):
        return np.empty(0, np.intp)
    order = np.lexsort(values.T[::-1])
    rows = values[order]
    fresh = np.append(True, np.any(rows[1:] != rows[:-1], axis=1))
    distinct = rows[fresh]
    candidates = _sieved(distinct)
    kept = np.zeros(len(distinct), bool)
    kept[candidates[_front(distinct[candidates])]] = True
    return np.sort(order[kept[np.cumsum(fresh) - 1]])


def _sieved(rows: Values) -> Indices:
    """Rows that are not dominated by a few that are likely to dominate many, those of the least sum of ranks."""
    ranks = np.argsort(np.argsort(rows, axis=0), axis=0).sum(axis=1)
    good = np.argsort(ranks, kind="stable")[:SIEVE]
    left = np.arange(len(rows))
    for k in good:
        # a row is at or below itself
        left = left[(left == k) | ~np.all(rows[k] <= rows[left], axis=1)]
    return left


def _front(rows: Values) -> Indices:
    """Indices of the front of distinct rows in lexicographic order."""
    if len(rows) <= SMALL:
        return np.flatnonzero(np.count_nonzero(_at_or_below(rows, rows), axis=0) == 1)
    half = len(rows) // 2
    upper, lower = _front(rows[:half]), half + _front(rows[half:])
    return np.concatenate((upper, lower[~_beaten(rows[lower, 1:], rows[upper, 1:])]))


def _beaten(rows: Values, others: Values) -> Mask:
    """Whether any of the others is at or below a row in all its values, (n,)."""
    if not len(rows) or not len(others):
        return np.zeros(len(rows), bool)
    if rows.shape[1] == 0:
        return np.ones(len(rows), bool)
    if rows.shape[1] == 1:
        return rows[:, 0] >= others.min()
    if len(rows) * len(others) <= PAIRS:
        return np.any(_at_or_below(rows, others), axis=0)
    if rows.shape[1] == 2:
        return _beaten_in_plane(rows, others)
    return _halved(rows, others)


def _beaten_in_plane(rows: Values, others: Values) -> Mask:
    """The same for two values: the least second value of all others up to the first value of a row."""
    order = np.argsort(others[:, 0], kind="stable")
    lowest = np.append(np.inf, np.minimum.accumulate(others[order, 1]))
    return lowest[np.searchsorted(others[order, 0], rows[:, 0], "right")] <= rows[:, 1]


def _halved(rows: Values, others: Values) -> Mask:
    """The same by halves of the last value; the lower half of the others is below the upper rows in any case."""
    last = np.concatenate((rows[:, -1], others[:, -1]))
    top = last.max()
    if last.min() == top:
        return _beaten(rows[:, :-1], others[:, :-1])
    pivot = np.partition(last, len(last) // 2)[len(last) // 2]
    if pivot == top:
        pivot = last[last < top].max()
    high, above = np.flatnonzero(rows[:, -1] > pivot), others[:, -1] > pivot
    low = np.flatnonzero(rows[:, -1] <= pivot)
    beaten = np.zeros(len(rows), bool)
    beaten[low] = _beaten(rows[low], others[~above])
    beaten[high] = _beaten(rows[high, :-1], others[~above, :-1])
    high = high[~beaten[high]]
    beaten[high] = _beaten(rows[high], others[above])
    return beaten


def _at_or_below(rows: Values, others: Values) -> Mask:
    """Whether each of the others is at or below each row in all values, (others, rows)."""
    below = others[:, None, 0] <= rows[None, :, 0]
    for k in range(1, rows.shape[1]):
        below &= others[:, None, k] <= rows[None, :, k]
    return below
