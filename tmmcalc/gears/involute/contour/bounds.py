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

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.side import Sloped
from tmmcalc.gears.model import Values

LOWER = ("interference2", "tolerated1", "undercut1", "thickness1", "thickness2", "contact_ratio", "tip1", "tip2")
UPPER = ("interference1", "tolerated2", "undercut2", "thickness1", "thickness2", "contact_ratio", "tip2", "tip1")
NEVER = 1e3  # a bound where a condition holds nowhere: beyond all shifts
STEPS = 60  # halving alone ends within them
TOUCH = 1e-13  # value that counts as zero where two branches touch
CLOSE = 1e-9  # step after which Newton's method is exact
NUDGE = 1e-9  # largest correction of a root in closed form
FLAT = 1e-3  # slope of the contact ratio below which both of its ends nearly meet and no step is safe

Curve = Callable[[Sums, Values], Sloped]
Kinds = NDArray[np.intp]
Flags = NDArray[np.bool_]


@record
class Cuts:
    """Bounds of x1 on n lines of constant sum."""

    sums: Sums
    lower: Values  # (8, n) by LOWER
    upper: Values  # (8, n) by UPPER

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


def cuts(frame: Frame, w: Values, region: int = 0, *, tolerated: bool = True) -> Cuts:
    """Bounds on the lines of the operating angles w (n,).

    ``region`` 0: both tip circles outside the reference circles, the main region; 1 (2): that of wheel 2 (1) inside,
    so that the contact lies on one side of the pitch point; 3: both inside. Without ``tolerated`` the bounds of
    tolerated undercut, which take longest, are left out: only the strict contour may be read off.
    """
    sums = frame.sums(w)
    lower, upper = np.full((len(LOWER), w.size), -NEVER), np.full((len(UPPER), w.size), NEVER)
    reach = sums.modification + frame.addendum  # largest x_i with the mate's tip outside its reference circle
    low1, high1 = _domain(frame, sums, reach, region)
    if region in (0, 1):
        lower[LOWER.index("tip1")] = sums.total - reach
    else:
        upper[UPPER.index("tip1")] = sums.total - reach
    if region in (0, 2):
        upper[UPPER.index("tip2")] = reach
    else:
        lower[LOWER.index("tip2")] = reach
    for i in (0, 1):
        low, high = (low1, high1) if i == 0 else (sums.total - high1, sums.total - low1)
        below, above = interference_ends(frame, i, sums, low, high, region in (i + 1, 3), tolerated)
        thin, thick = thickness_ends(frame, i, sums, low, high)
        _put(lower, upper, sums, i, f"tolerated{i + 1}", f"interference{i + 1}", below, above)
        _put(lower, upper, sums, i, f"thickness{i + 1}", f"thickness{i + 1}", thin, thick)
        _put(lower, upper, sums, i, f"undercut{i + 1}", "", np.full_like(low, frame.sides[i].least), high)
    _put(lower, upper, sums, 0, "contact_ratio", "contact_ratio", *contact_ends(frame, sums, low1, high1))
    return Cuts(sums, lower, upper)


def edge_names(low: str, high: str, region: int) -> tuple[str, str]:
    """The names of the edges; beyond a reference circle it is the other side of its line that bounds."""
    if region in (1, 3):
        low = {"tolerated1": "interference1"}.get(low, low)
    if region in (2, 3):
        high = {"tolerated2": "interference2"}.get(high, high)
    return low, high


def interference_ends(
    frame: Frame, i: int, sums: Sums, low: Values, high: Values, inside: bool, tolerated: bool
) -> tuple[Values, Values]:
    """Least and largest x_i between ``low`` and ``high`` without interference and harmful undercut.

    ``inside``: the mate's tip circle lies inside its reference circle, beyond the place of the least room. Without
    ``tolerated`` the bound of tolerated undercut is left out.
    """
    peak = high if inside else np.clip(frame.sides[i].least, low, high)
    positive = (frame.room(i, sums, peak)[0] >= 0) & (low <= high)
    towards, away = frame.room_roots(i, sums)
    if inside:
        # the flank below the root may be undercut; then the root is sought on the flank that is left
        plain = (away >= frame.sides[i].least) & positive
        above = np.where(positive, NEVER, -NEVER)
        below = np.where(plain & (away >= low), away, np.where(positive, -NEVER, NEVER))
        rest = positive & ~plain & (low < frame.sides[i].least)
        return np.where(rest, _edge(partial(frame.room, i), sums, peak, low, -NEVER, rest), below), above
    above = np.where(positive, np.where((towards <= high) & (peak < high), np.maximum(towards, peak), NEVER), -NEVER)
    if not tolerated:
        return np.where(positive, -NEVER, NEVER), above
    return np.where(positive, _edge(partial(frame.room, i), sums, peak, low, -NEVER, positive), NEVER), above


def thickness_ends(frame: Frame, i: int, sums: Sums, low: Values, high: Values) -> tuple[Values, Values]:
    """Least and largest x_i between ``low`` and ``high`` with a tip that is thick enough."""
    return _interval(partial(frame.thickness, i), sums, low, high, _thickest(frame, i, sums, low, high))


def contact_ends(frame: Frame, sums: Sums, low1: Values, high1: Values) -> tuple[Values, Values]:
    """Least and largest x1 between ``low1`` and ``high1`` with the contact ratio asked for."""
    split = np.clip(frame.best_split(sums), low1, high1)
    positive = (frame.overlap(sums, split)[0] >= 0) & (low1 <= high1)
    ends = []
    for found, free in zip(frame.overlap_roots(sums), (-NEVER, NEVER), strict=True):
        x = np.where(np.isnan(found), split, found)
        value, slope = frame.overlap(sums, x)
        with np.errstate(invalid="ignore", divide="ignore"):
            step = np.where(np.abs(slope) > FLAT, value / slope, 0.0)
        x = np.where(np.abs(step) < NUDGE, x - step, x)
        inside = (x > low1) if free < 0 else (x < high1)
        ends.append(np.where(positive, np.where(inside & ~np.isnan(found), x, free), -free))
    return ends[0], ends[1]


def _domain(frame: Frame, sums: Sums, reach: Values, region: int) -> tuple[Values, Values]:
    low1, high1 = sums.total - reach, reach
    one, two = frame.sides
    # a low tip still lies outside its base circle
    most, least = high1 + two.reference - two.base, low1 - one.reference + one.base
    if region == 1:
        return np.maximum(high1, low1), most
    if region == 2:
        return least, np.minimum(low1, high1)
    return (np.maximum(high1, least), np.minimum(low1, most)) if region == 3 else (low1, high1)


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
    value, slope = frame.thickness(i, sums, peak)
    which = np.flatnonzero((value < 0) & (slope > 0))
    if not which.size:
        return peak  # any place with a tip that is thick enough will do
    h = 1e-5

    def rise(some: Sums, x: Values) -> Sloped:
        return (
            frame.thickness(i, some, x)[1],
            (frame.thickness(i, some, x + h)[1] - frame.thickness(i, some, x - h)[1]) / (2 * h),
        )

    found = _edge(rise, sums.some(which), peak[which], high[which], NEVER, np.full(which.shape, True))
    peak[which] = np.minimum(found, high[which])
    return peak


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
