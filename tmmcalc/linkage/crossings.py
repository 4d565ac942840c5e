"""Where functions of the configuration change sign over a range: reversals of sliding, turning and piston motion.

The survey is dense, so its samples say almost everything: a root is interpolated from the four nearest, the function
is evaluated there once, and the same interpolation with that value in it is exact to rounding. Where that does not
settle, as near a singular position, the root is bracketed and searched.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extrema import with_turning_points
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.survey import Survey

Rates = Callable[[Configuration], list[Real]]
Flags = NDArray[np.bool_]

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

    def all_at(configuration: Configuration, n: int) -> Real:
        rows = np.empty((len(scales), n))
        for row, values in zip(rows, rates(configuration), strict=True):
            row[:] = values
        return rows

    def f(at: Real, function: Indices) -> Real:
        return np.asarray(all_at(chain.evaluate(at), at.size)[function, np.arange(at.size)])

    samples = all_at(dense.configuration, dense.x.size)
    largest = np.max(np.abs(samples), axis=1)
    moving = np.flatnonzero(largest > STILL * np.array(scales))
    parts = _brackets(f, moving, samples[moving], largest[moving], dense) if moving.size else []
    if not parts:
        return [np.empty(0) for _ in scales]
    cells = parts[0] if len(parts) == 1 else _Brackets(*map(np.concatenate, zip(*parts, strict=True)))
    roots = _roots(f, cells) if cells.function.size else np.empty(0)
    return [roots[cells.function == k] for k in range(len(scales))]


def _brackets(
    f: Callable[[Real, Indices], Real], functions: Indices, values: Real, largest: Real, dense: Survey
) -> list[_Brackets]:
    """The cells of the functions (F,) with samples (F, m) and their largest sizes (F,), short cells included."""
    x, period = dense.x, TURN if dense.full else None
    if dense.full:
        values = np.concatenate((values[:, :-1], values[:, :1]), axis=1)
    near = _nears(values, largest, dense.full)
    parts = [] if near.all() else [_cells(functions[~near], x, values[~near], dense.full)]
    for j in np.flatnonzero(near):
        size = float(largest[j])
        alone = _alone(f, int(functions[j]))
        more = with_turning_points(alone, x, values[j], near=NEAR * size, period=period, touch=1e-13 * size)
        parts.append(_cells(functions[j : j + 1], more[0], more[1][None], dense.full))
    return parts


def _alone(f: Callable[[Real, Indices], Real], function: int) -> Callable[[Real, Indices], Real]:
    """One of the functions by itself."""
    return lambda at, _: f(at, np.full(at.size, function))


def _cells(functions: Indices, x: Real, values: Real, full: bool) -> _Brackets:
    """The cells of ``x`` (m,) in which the values (F, m) of the functions (F,) change sign."""
    negative = np.signbit(values)
    row, cell = np.nonzero(negative[:, 1:] != negative[:, :-1])
    low, high = x[cell], x[cell + 1]
    if full:
        x = np.concatenate((x[-2:-1] - TURN, x, x[1:2] + TURN))
        values = np.concatenate((values[:, -2:-1], values, values[:, 1:2]), axis=1)
        cell = cell + 1
    first = np.clip(cell - POINTS // 2 + 1, 0, max(len(x) - POINTS, 0))
    around = first[:, None] + np.arange(min(POINTS, len(x)))
    return _Brackets(functions[row], x[around], values[row[:, None], around], low, high)


def _nears(values: Real, largest: Real, full: bool) -> Flags:
    """Which functions (F,) may touch zero between two samples: they turn back near to it without changing sign."""
    before, after = (values[:, -2:-1], values[:, 1:2]) if full else (values[:, :1], values[:, -1:])
    v = np.concatenate((before, values, after), axis=1)
    size, step, negative = np.abs(v), np.abs(v[:, 1:] - v[:, :-1]), np.signbit(v)
    stays = negative[:, 1:] == negative[:, :-1]
    inner = size[:, 1:-1]
    turns = (inner <= size[:, :-2]) & (inner <= size[:, 2:]) & stays[:, 1:] & stays[:, :-1]
    return np.any(turns & (inner < np.maximum(NEAR * largest[:, None], np.maximum(step[:, 1:], step[:, :-1]))), axis=1)


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
