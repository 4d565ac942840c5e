"""Values and integrals between the rows of a table: those of cubics through the four nearest rows.

Rows of one place part what runs over a jump, and no cubic reaches over it. Of a turn that closes the rows go on at both
ends; on equal steps the integral is then that of the trapezoid rule, which converges faster than any power of the step.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]

NEAREST, FURTHER = 4, 6  # rows through which a value is taken, and those that tell how good it is
GAUSS = 0.5 / 3**0.5  # of a step, from its middle to the points whose mean is exact for cubics


def between(x: Values, values: Values, at: float, closed: bool) -> tuple[float, float]:
    """The value at a place between the rows (n,), and its distance from the polynomial through six rows."""
    value, further = (float(_through(x, values, np.array([at]), count, closed)[0]) for count in (NEAREST, FURTHER))
    return value, abs(value - further)


def integral(x: Values, values: Values, closed: bool) -> float:
    """Of the cubics through the rows, exact for these, step by step."""
    step, middle = np.diff(x), (x[1:] + x[:-1]) / 2
    wide = step != 0
    points = (middle[wide] + sign * GAUSS * step[wide] for sign in (-1, 1))
    low, high = (_through(x, values, at, NEAREST, closed) for at in points)
    return float(np.sum(step[wide] * (low + high) / 2))


def _through(x: Values, values: Values, at: Values, count: int, closed: bool) -> Values:
    """Values (m,) at places of the polynomials through the ``count`` nearest of the rows (n,), half on each side.

    Rows of one place part what runs over a jump. Of a turn that closes the rows go on at both ends.
    """
    if x[-1] < x[0]:
        return _through(-x, values, -at, count, closed)
    jumps = np.flatnonzero(np.diff(x) == 0)
    if closed and not jumps.size:
        beyond, turn = min(count, len(x) - 1), x[-1] - x[0]
        x = np.concatenate((x[-1 - beyond : -1] - turn, x, x[1 : 1 + beyond] + turn))
        values = np.concatenate((values[-1 - beyond : -1], values, values[1 : 1 + beyond]))
    found = np.empty(len(at))
    for low, high in pairwise([0, *(jumps + 1).tolist(), len(x)]):
        own = x[low:high]
        here = (at >= own[0]) & ((at <= own[-1]) if high == len(x) else (at < own[-1]))
        if here.any():
            found[here] = _lagrange(own, values[low:high], at[here], min(count, len(own)))
    return found


def _lagrange(x: Values, values: Values, at: Values, count: int) -> Values:
    """Values (m,) of the polynomials through so many of the rows (n,) about each place."""
    begin = np.clip(np.searchsorted(x, at) - count // 2, 0, len(x) - count)
    rows = begin[:, None] + np.arange(count)
    nodes, gap = x[rows], at[:, None] - x[rows]
    found = np.zeros(len(at))
    for k in range(count):
        others = np.arange(count) != k
        found += values[rows[:, k]] * np.prod(gap[:, others] / (nodes[:, [k]] - nodes[:, others]), axis=1)
    return found
