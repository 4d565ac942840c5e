"""Error estimates of what is exact but for rounding: a few rows and all extremes computed again in extended precision.

The formulas take their precision from what they are given. So a record with all its floats made wide, and the same
functions, give values with a mantissa of 64 bits, beside which the difference of the ordinary ones is their error. The
rows computed again are an even spread and those named as the worst; a factor stands for the rows left out. Of a root
the error is what is left over the slope there. All errors are relative to the largest magnitude of the quantity.
Where the platform has no wider float, the estimate is a multiple of the rounding unit.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmmcalc.cams.laws.law import ORDERS, Indices, Law, Values
from tmmcalc.cams.program import SAME, Positions, Program
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import CHAIN, EPS, WIDER

CHOSEN = 48  # rows computed again
MARGIN = 6.0  # factor for the rows left out
FLOOR = MARGIN * EPS if WIDER else CHAIN
APART = 1e-3  # of a central difference in extended precision
FIRST = np.array([-1, 9, -45, 0, 45, -9, 1]) / np.longdouble(60)
SECOND = np.array([2, -27, 270, -490, 270, -27, 2]) / np.longdouble(180)

Errors = dict[str, float]
Function = Callable[[Values], Values]


def chosen(count: int, *sizes: Any) -> Indices:
    """Numbers of the rows that are computed again: an even spread, and where each of the ``sizes`` (n,) is largest."""
    spread = np.linspace(0, count - 1, min(count, CHOSEN)).astype(int)
    worst = [int(np.argmax(np.abs(size))) for size in sizes]
    return np.array(sorted({*spread.tolist(), *worst}), dtype=np.intp)


def steep(phi: Values, motion: Values) -> Values:
    """What a rounding of the angles (n,) moves acceleration and velocity by, (2, n): large in few rows of some laws."""
    found: Values = motion[2:] * phi
    return found


def again(program: Program, rows: Positions, which: Indices) -> tuple[Values, Values]:
    """Angles (m,) and motion (4, m) of some rows in extended precision."""
    phi = wide(rows.phi[which])
    return phi, program.wider.at(phi, rows.piece[which])


def sides(program: Program, phi: Values) -> Positions:
    """Rows (2 m,) before and after angles (m,), which differ on an edge alone."""
    edges, near = program.edges, SAME * float(program.starts[-1])
    last = len(edges) - 2
    before = np.clip(np.searchsorted(edges, phi - near) - 1, 0, last)
    after = np.clip(np.searchsorted(edges, phi + near) - 1, 0, last)
    return Positions(np.tile(phi, 2), np.concatenate((before, after)), ())


def relative(found: Any, exact: Any, size: float | None = None) -> float:
    """Estimate from values and the same in extended precision, over the largest of them or over ``size``."""
    found, exact = np.asarray(found), np.asarray(exact)
    scale = float(np.max(np.abs(exact), initial=0.0)) if size is None else size
    if not scale:
        return 0.0
    return max(MARGIN * float(np.max(np.abs(found - exact), initial=0.0)) / scale, FLOOR)


def nearer(found: Any, exact: Values, size: float | None = None) -> float:
    """The same for extremes (m,) found, of values (2 m,) on both `sides`: the nearer one is meant."""
    both = np.reshape(exact, (2, -1))
    gap = np.abs(np.asarray(found) - both)
    return relative(found, np.where(gap[0] <= gap[1], both[0], both[1]), size)


def slopes(f: Function, x: float, apart: float = APART) -> tuple[float, float, float]:
    """f and its first two derivatives at x by differences of the sixth order in extended precision."""
    step = np.longdouble(apart)
    values = f(np.longdouble(x) + step * np.arange(-3, 4))
    return float(values[3]), float(FIRST @ values / step), float(SECOND @ values / step**2)


def crest(f: Function, x: float, apart: float) -> tuple[Any, Any]:
    """Value and place of the extreme of f near x in extended precision; how far x is from it is seen in the slope."""
    step = np.longdouble(apart)
    at = np.longdouble(x) + step * np.arange(-3, 4)
    values = f(at)
    slope, bend = FIRST @ values / step, SECOND @ values / step**2
    shift = -slope / bend if bend else 0 * slope
    if abs(shift) > step:
        return values[3], at[3]
    return values[3] + slope * shift / 2, at[3] + shift


def root_error(f: Function, x: float, apart: float = APART) -> float:
    """How far x is from a root of f, by one step of Newton; 0 where f is level."""
    value, slope, _ = slopes(f, x, apart)
    return abs(value / slope) if slope else 0.0


def joints(program: Program) -> Values:
    """By what the motion (4,) misses its continuity at the edges, relative, where that is rounding and no jump.

    It is the rounding of the coefficients of the laws, which no other way to evaluate them shows.
    """
    exact = program.wider
    every = np.arange(len(exact.edges) - 1)
    after, before = exact.at(exact.edges[:-1], every), exact.at(exact.edges[1:], every)
    return _missing(after - np.roll(before, 1, axis=1), np.max(np.abs(program.sampled), axis=(1, 2)))


def law_joints(law: Law) -> Values:
    """The same (4,) of a law in extended precision at its breaks, and of s, s' at its ends."""
    every = np.arange(law.count)
    after, before = law.at(law.breaks[:-1], every), law.at(law.breaks[1:], every)
    size = np.max(np.abs(np.concatenate((after, before), axis=1)), axis=1)
    rest = np.zeros((ORDERS, 2), before.dtype)
    rest[0], rest[1] = (after[0, 0], before[0, -1] - 1), (after[1, 0], before[1, -1])
    return _missing(np.concatenate((after[:, 1:] - before[:, :-1], rest), axis=1), size)


def _missing(jump: Values, size: Values) -> Values:
    """The largest of the jumps (4, m) that are rounding, over the size (4,) of the quantity."""
    jump, size = np.abs(jump), size[:, None]
    small = jump <= SAME * size
    return np.max(np.where(small, jump, 0.0) / np.where(size > 0, size, 1.0), axis=1, initial=0.0).astype(float)
