"""Derivatives of functions by differences that are extrapolated to no step, each with its error.

Differences over steps s/16, s/32, ... to both sides of a place: central ones have errors in even powers of the step,
those to one side in all powers, and are extrapolated so (Richardson; of the table of Romberg the entry with the least
error is taken, as Ridders does). Where what is found to the two sides differs by more than the errors the function has
a kink; where it does not come to its value at the place it jumps; where it has values to one side alone, or its
differences do not settle, no straight line stands for it.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]
Side = Literal["both", "right", "left", "kink", "jump", "none"]

LEVELS = 9  # steps to a side, each half of the one before
FIRST = 1 / 16  # the largest, as a part of the scale
COLUMNS = 6  # powers of the step that are removed
SMALLEST = 5  # steps to a side by which scatter is seen
SAFE = 3.0  # times the scatter is taken for the noise
SURE = 20.0  # times the errors that two sides have to differ by to be a kink
UNSETTLED = 0.05  # of the derivative: an error above means that no straight line stands for the function
STAYS = 0.9  # of a difference from the value at the place, at half of the step: it is a jump
NOISE = 8 * np.finfo(float).eps  # of a value
FLOOR = 1e4 * NOISE  # of its unit: smaller differences are rounding of what the result was made of


@record
class Slope:
    """The derivative of one result with respect to one key, and what the steps to both sides told."""

    value: float  # NaN where there is none
    error: float
    side: Side  # what it was taken from
    right: float  # to the side of larger values of the key; NaN: none
    left: float
    curvature: float  # second derivative; NaN: none


def steps(scale: float) -> Values:
    """Steps (2 L,) to be added to a value: L to larger values, the largest first, then L to smaller ones."""
    right = scale * FIRST * 0.5 ** np.arange(LEVELS)
    return np.concatenate((right, -right))


def slope(scale: float, here: float, there: Values) -> Slope:
    """The derivative from the value at a place and the values (2 L,) at its `steps`, NaN where there is none.

    >>> found = slope(1.0, 1.0, np.exp(steps(1.0)))
    >>> abs(found.value - 1) < found.error < 1e-11, found.side
    (True, 'both')
    >>> slope(1.0, 0.0, np.abs(steps(1.0))).side
    'kink'
    """
    h = steps(scale)[:LEVELS]
    if np.all(there == here):
        return Slope(0.0, 0.0, "both", 0.0, 0.0, 0.0)
    up, down = there[:LEVELS], there[LEVELS:]
    size = max(abs(here), float(np.max(np.abs(there[np.isfinite(there)]), initial=0.0)))
    if _jumps(up - here, size) or _jumps(down - here, size):
        return Slope(np.nan, np.nan, "jump", np.nan, np.nan, np.nan)
    noise = max(NOISE * size, SAFE * scatter(here, up, down)) / h
    right, right_error = extrapolated((up - here) / h, noise, 1)
    left, left_error = extrapolated((here - down) / h, noise, 1)
    if np.isnan(right) or np.isnan(left):
        return _one_sided(right, right_error, left, left_error)
    both, error = extrapolated((up - down) / (2 * h), noise, 2)
    curvature, _ = extrapolated((up - 2 * here + down) / h**2, 4 * noise / h, 2)
    apart = abs(right - left)
    if apart > SURE * (right_error + left_error) and apart > error:
        return Slope(np.nan, max(right_error, left_error), "kink", right, left, np.nan)
    side: Side = "none" if error > UNSETTLED * abs(both) and error > NOISE * size / h[-1] + FLOOR / scale else "both"
    return Slope(both, error, side, right, left, curvature)


def _one_sided(right: float, right_error: float, left: float, left_error: float) -> Slope:
    """The derivative where the function has values to one side alone, or to none."""
    side: Side = "right" if np.isnan(left) else "left"
    value, error = (right, right_error) if side == "right" else (left, left_error)
    if np.isnan(value) or error > UNSETTLED * abs(value):
        side = "none"
    return Slope(value, error, side, right, left, np.nan)


def _jumps(differences: Values, size: float) -> bool:
    """Whether differences over halved steps do not go to nothing."""
    known = np.abs(differences[np.isfinite(differences)])
    if known.size < 3 or known[-1] <= max(1e3 * NOISE * size, FLOOR):
        return False
    return bool(known[-1] >= STAYS * known[-2] and known[-2] >= STAYS * known[-3])


def scatter(here: float, up: Values, down: Values) -> float:
    """How much values scatter about smooth curves to both sides, by what no parabola of fourth degree explains.

    The values (L,) are those at halved steps. Of the smallest ones and of those one step larger, to both sides, the
    second least counts: a kink nearby is in two of these four.
    """
    x = np.concatenate(([0.0], 2.0 ** np.arange(SMALLEST)))
    apart = x[:, None] - x + np.eye(len(x))
    weights = 1 / np.prod(apart, axis=1)  # of the divided difference
    smallest = [side[::-1][first : first + SMALLEST] for side in (up, down) for first in (0, 1)]
    seen = [abs(float(weights @ np.concatenate(([here], own)))) for own in smallest]
    known = sorted(each for each in seen if np.isfinite(each))
    return known[min(1, len(known) - 1)] / float(np.linalg.norm(weights)) if known else 0.0


def extrapolated(differences: Values, noise: Values, power: int) -> tuple[float, float]:
    """What quotients over halved steps go to, and its error; NaN where fewer than three are known.

    ``noise`` is what rounding leaves of each; their errors are in powers ``power``, 2 ``power``, ... of the step.
    """
    known = np.isfinite(differences)
    differences, noise = differences[known], noise[known]
    if differences.size < 3:
        return np.nan, np.nan
    column, columns = differences, [differences]
    for k in range(1, min(COLUMNS, differences.size - 1) + 1):
        column = column[1:] + (column[1:] - column[:-1]) / (2.0 ** (power * k) - 1)
        columns.append(column)
    found: list[tuple[float, float]] = []
    for k in range(1, len(columns)):
        own, before = columns[k], columns[k - 1]
        error = np.maximum(np.abs(own - before[1:]), np.abs(own - before[:-1])) + noise[k:]
        found += zip(error.tolist(), own.tolist(), strict=True)
    found.sort()
    least, best = found[0]
    # an entry may agree with its neighbours by chance: the next best ones have a say
    return best, max([least, *(min(abs(other - best), told) for told, other in found[1:3])])
