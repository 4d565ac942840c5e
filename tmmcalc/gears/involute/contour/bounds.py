"""The admissible shifts x1 on lines of constant sum: what bounds them from below and from above.

On each line every condition holds on one interval of x1. Both of its ends are roots in one variable, found by Newton's
method inside a bracket for all lines at once. The interval common to all conditions is the cut of the line
with the contour; the conditions that give its ends are the names of the edges there.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.involute.contour.form import Sloped
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.model import Values
from tmmcalc.records import record

LOWER = ("interference2", "tolerated1", "undercut1", "thickness1", "thickness2", "contact_ratio", "tip1")
UPPER = ("interference1", "tolerated2", "undercut2", "thickness1", "thickness2", "contact_ratio", "tip2")
NEVER = 1e3  # a bound where a condition holds nowhere: beyond all shifts
STEPS = 60  # halving alone ends within them
TOUCH = 1e-13  # value that counts as zero where two branches touch
CLOSE = 1e-9  # step after which Newton's method is exact

Curve = Callable[[Sums, Values], Sloped]
Kinds = NDArray[np.intp]
Flags = NDArray[np.bool_]


@record
class Cuts:
    """Bounds of x1 on n lines of constant sum."""

    sums: Sums
    lower: Values  # (7, n) by LOWER
    upper: Values  # (7, n) by UPPER

    def ends(self, strict: bool) -> tuple[Values, Values, Kinds, Kinds]:
        """Lowest and highest x1 (n,) and the numbers of the conditions that give them; empty where lowest > highest."""
        lower, upper = self.lower, self.upper
        if not strict:
            lower, upper = lower.copy(), upper.copy()
            lower[LOWER.index("undercut1")] = -NEVER
            upper[UPPER.index("undercut2")] = NEVER
        low, high = np.argmax(lower, axis=0), np.argmin(upper, axis=0)
        every = np.arange(low.size)
        return lower[low, every], upper[high, every], low, high


def cuts(frame: Frame, w: Values, region: int = 0) -> Cuts:
    """Bounds on the lines of the operating angles w (n,).

    ``region`` 0: both tip circles outside the reference circles, the main region; 1 (2): that of wheel 2 (1) inside,
    so that the contact lies on one side of the pitch point.
    """
    sums = frame.sums(w)
    lower, upper = np.full((7, w.size), -NEVER), np.full((7, w.size), NEVER)
    reach = sums.modification + frame.addendum  # largest x_i with the mate's tip outside its reference circle
    low1, high1 = _domain(frame, sums, reach, region)
    for i in (0, 1):
        low, high = (low1, high1) if i == 0 else (sums.total - high1, sums.total - low1)
        side = frame.sides[i]
        beyond = region == i + 1
        peak = high if beyond else np.clip(side.least, low, high)
        below, above = _interval(partial(frame.room, i), sums, low, high, peak)
        thin, thick = _interval(partial(frame.thickness, i), sums, low, high, _thickest(frame, i, sums, low, high))
        _put(lower, upper, sums, i, f"tolerated{i + 1}", f"interference{i + 1}", below, above)
        _put(lower, upper, sums, i, f"thickness{i + 1}", f"thickness{i + 1}", thin, thick)
        _put(lower, upper, sums, i, f"undercut{i + 1}", "", np.full_like(low, side.least), high)
    split = np.clip(frame.best_split(sums), low1, high1)
    below, above = _interval(frame.overlap, sums, low1, high1, split)
    _put(lower, upper, sums, 0, "contact_ratio", "contact_ratio", below, above)
    _put(lower, upper, sums, 0, "tip1", "tip2", low1, high1)
    return Cuts(sums, lower, upper)


def _domain(frame: Frame, sums: Sums, reach: Values, region: int) -> tuple[Values, Values]:
    low1, high1 = sums.total - reach, reach
    one, two = frame.sides
    if region == 1:
        return np.maximum(high1, low1), high1 + two.reference - two.base
    if region == 2:
        return low1 - one.reference + one.base, np.minimum(low1, high1)
    return low1, high1


def _put(lower: Values, upper: Values, sums: Sums, i: int, below: str, above: str, least: Values, most: Values) -> None:
    """Enter an interval of x_i as bounds of x1."""
    low_name, high_name = (below, above) if i == 0 else (above, below)
    low, high = (least, most) if i == 0 else (sums.total - most, sums.total - least)
    if low_name:
        lower[LOWER.index(low_name)] = low
    if high_name:
        upper[UPPER.index(high_name)] = high


def _thickest(frame: Frame, i: int, sums: Sums, low: Values, high: Values) -> Values:
    """The x_i of the relatively thickest tip: on the reference circle, a little beyond it if a thickness is asked."""
    peak = np.clip(sums.total - frame.addendum - sums.modification, low, high)
    if not frame.sides[i].thickness:
        return peak
    rising = frame.thickness(i, sums, peak)[1] > 0
    h = 1e-5

    def slope(some: Sums, x: Values) -> Sloped:
        return (
            frame.thickness(i, some, x)[1],
            (frame.thickness(i, some, x + h)[1] - frame.thickness(i, some, x - h)[1]) / (2 * h),
        )

    found = _edge(slope, sums, peak, high, NEVER, rising)
    return np.where(rising, np.minimum(found, high), peak)


def _interval(curve: Curve, sums: Sums, low: Values, high: Values, peak: Values) -> tuple[Values, Values]:
    """Where a function that rises to ``peak`` and falls after it is not negative.

    An end beyond low or high is -NEVER or NEVER; a function negative everywhere gives (NEVER, -NEVER).
    """
    top = curve(sums, peak)[0]
    positive = (top >= 0) & (low <= high)
    return (
        np.where(positive, _edge(curve, sums, peak, low, -NEVER, positive), NEVER),
        np.where(positive, _edge(curve, sums, peak, high, NEVER, positive), -NEVER),
    )


def _edge(curve: Curve, sums: Sums, inside: Values, outside: Values, free: float, wanted: Flags) -> Values:
    """The root between an x with a value >= 0 and one beyond it, where the value there is negative; else ``free``."""
    result = np.full(inside.shape, free)
    if not wanted.any():
        return result
    there = curve(sums, outside)[0]
    # where two branches of a line touch, its value at the touch is zero but for rounding
    result[wanted & (there < TOUCH)] = outside[wanted & (there < TOUCH)]
    which = np.flatnonzero(wanted & (there < -TOUCH))
    if which.size:
        result[which] = root(curve, sums.some(which), inside[which], outside[which])
    return result


def root(curve: Curve, sums: Sums, inside: Values, outside: Values) -> Values:
    """Roots (n,) between values >= 0 and values < 0: Newton from the latter, halving where a step leaves."""
    good, bad, x = inside, outside, outside
    last = np.full_like(x, -1.0)
    for _ in range(STEPS):
        value, slope = curve(sums, x)
        good, bad = np.where(value >= 0, x, good), np.where(value >= 0, bad, x)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = x - value / slope
        low, high = np.minimum(good, bad), np.maximum(good, bad)
        new = np.where((step >= low) & (step <= high), step, (good + bad) / 2)
        size = np.abs(new - x)
        # the error after a step is of the order of its square, unless the curve is upright at the base circle
        if np.all((size <= CLOSE) & (size <= last)):
            return new
        x, last = new, size
    return x
