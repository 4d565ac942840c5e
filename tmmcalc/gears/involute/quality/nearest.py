"""The shifts nearest to given ones at which a pair is possible, by its least margin over x1 and x2."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot, pi

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.gears.model import Values

REACH = 3.0  # how far from the given shifts the nearest admissible ones are sought
STEPS = 60  # along a ray
RAYS = 72  # directions in the plane (x1, x2)
ZOOMS = 7  # looks between the neighbours of the best ray: its direction ends within 1e-5 rad
PARTS = np.arange(1, 25) / 24  # of the step in which a ray enters
PASSES = 5  # the entry ends within 1e-8
INWARD = 1e-9  # the shifts found are moved so far inward, beyond the error of the polynomial
GRID = 121  # sums, and shifts on a line of one sum, that are looked at for the outermost sum
HALVINGS = 24  # of the step between two sums

Margin = Callable[[Values, Values], Values]  # over x1 and x2 (n,)


@record
class Nearest:
    """The nearest admissible shifts, and how far they are."""

    shifts: tuple[float, float]  # x1, x2
    distance: float  # in the plane (x1, x2)


def nearest_admitted(least: Margin, start: tuple[float, float], direction: float | None = None) -> Nearest | None:
    """The point nearest to ``start`` where a margin over the shifts (n,) is not negative; None: none within 3."""

    def admitted(angle: Values, t: Values) -> NDArray[np.bool_]:
        x1, x2 = start[0] + t * np.cos(angle), start[1] + t * np.sin(angle)
        return least(x1.ravel(), x2.ravel()).reshape(x1.shape) >= 0

    if direction is not None:
        angles = np.array([direction, direction + pi])
        lengths = _entries(admitted, angles)
    else:
        angles = np.arange(RAYS) * (2 * pi / RAYS)
        lengths = _entries(admitted, angles)
        for zoom in range(ZOOMS):
            middle, width = angles[np.argmin(lengths)], 2 * pi / RAYS / 5**zoom
            angles = middle + width * np.linspace(-1, 1, 11)
            lengths = _entries(admitted, angles)
    at, angle = float(np.min(lengths)), float(angles[np.argmin(lengths)])
    if not np.isfinite(at):
        return None
    at += INWARD if at else 0.0
    x1, x2 = start[0] + at * float(np.cos(angle)), start[1] + at * float(np.sin(angle))
    return Nearest((round(x1, 12) + 0.0, round(x2, 12) + 0.0), at)


def _entries(admitted: Callable[[Values, Values], NDArray[np.bool_]], angles: Values) -> Values:
    """How far along each ray (k,) the first admissible point lies; inf: there is none."""
    steps = np.linspace(0.0, REACH, STEPS + 1)
    inside = admitted(angles[:, None], np.broadcast_to(steps, (len(angles), len(steps))))
    index, hit = np.argmax(inside, axis=1), inside.any(axis=1)
    lengths = np.where(hit, steps[index], np.inf)
    # only rays that may hold the nearest point are worth refining
    near = np.flatnonzero((index > 0) & (lengths <= np.min(lengths) + steps[1]))
    low, width = lengths[near] - steps[1], steps[1]
    for _ in range(PASSES if near.size else 0):
        trial = low[:, None] + width * PARTS
        inside = admitted(angles[near, None], trial)
        inside[:, -1] = True  # the end was found admissible before
        lengths[near] = trial[np.arange(near.size), np.argmax(inside, axis=1)]
        width = width * PARTS[0]
        low = lengths[near] - width
    return lengths


def told_nearest(fast: Margin, exact: Margin, start: tuple[float, float]) -> str:
    """The shifts nearest to ``start`` in the plane and along its main lines, in words; empty if there are none.

    Both margins are the same, the first to about 1e-9.
    """
    found: dict[str, tuple[float, float]] = {}
    for direction, text in ((None, ""), (0.0, "x1 alone: "), (pi / 2, "x2 alone: "), (-pi / 4, "at this x1 + x2: ")):
        along = nearest_admitted(fast, start, direction)
        if direction is None and along is None:
            return ""
        if along is not None:
            found[text] = _rounded(exact, start, along)
    # rounding may carry the nearest of all beyond the nearest of a line
    away = {text: hypot(x1 - start[0], x2 - start[1]) for text, (x1, x2) in found.items()}
    found[""] = found[min(away, key=lambda text: (away[text], text == ""))]
    told = (f"{text}x1 = {x1:.6g}, x2 = {x2:.6g}" for text, (x1, x2) in found.items())
    return "the nearest admissible shifts are " + "; ".join(told)


def _rounded(least: Margin, at: tuple[float, float], nearest: Nearest) -> tuple[float, float]:
    """The shifts with four decimals where they change, a little farther along if rounding leads out again."""
    start, end = np.array(at), np.array(nearest.shifts)
    along = end - start
    points = end + np.arange(41)[:, None] / 20000 * along / (nearest.distance or 1.0)
    shifts = np.where(np.abs(along) > 1e-9, np.round(points, 4), start)
    if abs(along.sum()) < 1e-9:
        shifts[:, 1] = start.sum() - shifts[:, 0]
    good = np.flatnonzero(least(shifts[:, 0], shifts[:, 1]) >= 0)
    x1, x2 = shifts[good[0]] if good.size else end
    return float(x1) + 0.0, float(x2) + 0.0


def outermost_sum(least: Margin, bound: float, inward: float) -> tuple[float, float] | None:
    """x1 and x2 of the admissible sum nearest to ``bound``, in the direction ``inward`` (1 or -1); None: there is none.

    The shift x1 is the one of the largest margin.
    """
    sums = bound + inward * np.linspace(0.0, 2 * REACH, GRID)
    x1 = sums[:, None] / 2 + np.linspace(-REACH, REACH, GRID)
    margins = least(x1.ravel(), (sums[:, None] - x1).ravel()).reshape(x1.shape)
    good = np.flatnonzero(margins.max(axis=1) >= 0)
    if not good.size:
        return None
    k = int(good[0])
    at = float(x1[k, np.argmax(margins[k])])
    inside, outside = float(sums[k]), float(sums[max(k - 1, 0)])
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        one, margin = best_split(least, middle, at - sums[k] / 2 + middle / 2)
        if margin >= 0:
            inside = middle
        else:
            outside = middle
    one, _ = best_split(least, inside, at - float(sums[k]) / 2 + inside / 2)
    return one, inside - one


def best_split(least: Margin, total: float, near: float) -> tuple[float, float]:
    """x1 of the largest margin at x1 + x2, sought around ``near``, and that margin."""
    width = 20 * REACH / GRID
    for _ in range(4):
        x1 = near + np.linspace(-width, width, GRID)
        margins = least(x1, total - x1)
        near, width = float(x1[np.argmax(margins)]), width / 20
    return near, float(np.max(margins))
