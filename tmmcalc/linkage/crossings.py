"""Where functions of the configuration change sign over a range: reversals of sliding, turning and piston motion.

The survey is dense, so its samples say almost everything: a root is interpolated from the four nearest, the function
is evaluated there once, and the same interpolation with that value in it is exact to rounding. Where that does not
settle, as near a singular position, the root is bracketed and searched.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.survey import Survey
from tmmcalc.numerics.extrema import with_turning_points
from tmmcalc.numerics.roots import Indices, bracketed

Rates = Callable[[Configuration], list[Real]]

STILL = 1e-11  # a rate below this part of its scale is rest
NEAR = 0.02  # a turning point nearer to zero than this part of the largest value is always looked at
SETTLED = 1e-4  # change of an interpolated root, against its bracket, from which on its digits more than double
POINTS = 4  # samples that a root is interpolated from


class _Brackets(NamedTuple):
    """Cells in which functions change sign: number of the function (m,), samples about the cell (m, POINTS)."""

    function: Indices
    x: Real
    values: Real
    low: Real  # the cell (m,)
    high: Real


def crossings(chain: Chain, rates: Rates, scales: list[float], dense: Survey) -> list[Real]:
    """Ascending input coordinates, one array a function, at which it changes sign over the survey.

    ``rates(configuration)`` gives the functions, each (n,) or a constant; one that never exceeds `STILL` times its
    scale is zero everywhere and has no crossing.
    """

    def f(at: Real, function: Indices) -> Real:
        rows = [np.broadcast_to(v, at.shape) for v in rates(chain.evaluate(at))]
        return np.array(rows)[function, np.arange(at.size)]

    samples = [np.broadcast_to(v, dense.x.shape) for v in rates(dense.configuration)]
    parts = [
        _brackets(f, k, values, dense)
        for k, (values, scale) in enumerate(zip(samples, scales, strict=True))
        if float(np.max(np.abs(values))) > STILL * scale
    ]
    if not parts:
        return [np.empty(0) for _ in samples]
    cells = _Brackets(*(np.concatenate(column) for column in zip(*parts, strict=True)))
    roots = _roots(f, cells) if cells.function.size else np.empty(0)
    return [roots[cells.function == k] for k in range(len(samples))]


def _brackets(f: Callable[[Real, Indices], Real], k: int, values: Real, dense: Survey) -> _Brackets:
    """The cells of function k, short ones between two samples included."""
    x, largest = dense.x, float(np.max(np.abs(values)))
    values = np.append(values[:-1], values[0]) if dense.full else values
    if _nears(values, largest, dense.full):
        x, values = with_turning_points(
            lambda at, _: f(at, np.full(at.size, k)),
            x,
            values,
            near=NEAR * largest,
            period=TURN if dense.full else None,
            touch=1e-13 * largest,
        )
    cell = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    low, high = x[cell], x[cell + 1]
    if dense.full:
        x = np.concatenate((x[-2:-1] - TURN, x, x[1:2] + TURN))
        values = np.concatenate((values[-2:-1], values, values[1:2]))
        cell = cell + 1
    around = np.clip(cell - POINTS // 2 + 1, 0, max(len(x) - POINTS, 0))[:, None] + np.arange(min(POINTS, len(x)))
    return _Brackets(np.full(cell.size, k), x[around], values[around], low, high)


def _nears(values: Real, largest: float, full: bool) -> bool:
    """Whether a function may touch zero between two samples: it turns back near to it without changing its sign."""
    v = np.concatenate((values[-2:-1], values, values[1:2])) if full else np.pad(values, 1, mode="edge")
    size, step = np.abs(v), np.abs(np.diff(v))
    crosses = np.signbit(v[1:]) != np.signbit(v[:-1])
    turns = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & ~(crosses[1:] | crosses[:-1])
    return bool(np.any(turns & (size[1:-1] < np.maximum(NEAR * largest, np.maximum(step[1:], step[:-1])))))


def _roots(f: Callable[[Real, Indices], Real], cells: _Brackets) -> Real:
    first = np.clip(_inverse(cells.x, cells.values), cells.low, cells.high)
    first = np.where(np.isfinite(first), first, cells.low)
    there = f(first, cells.function)
    root = _inverse(np.append(cells.x, first[:, None], axis=1), np.append(cells.values, there[:, None], axis=1))
    exact = there == 0
    settled = np.abs(root - first) <= SETTLED * (cells.high - cells.low)
    root = np.where(exact, first, root)
    hard = np.flatnonzero(~(settled & (root >= cells.low) & (root <= cells.high)) & ~exact)
    if hard.size:
        root[hard] = bracketed(lambda at, k: f(at, cells.function[hard[k]]), cells.low[hard], cells.high[hard])
    return root


def _inverse(x: Real, values: Real) -> Real:
    """The polynomial that gives x (m, p) from the values (m, p), at the value 0: (m,)."""
    gap = values[:, :, None] - values[:, None, :]
    p = x.shape[1]
    factor = np.broadcast_to(-values[:, None, :], gap.shape).copy()
    factor[:, np.arange(p), np.arange(p)] = gap[:, np.arange(p), np.arange(p)] = 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        weights = np.prod(factor / gap, axis=2)
        return np.asarray((weights * (x - x[:, :1])).sum(axis=1) + x[:, 0])
