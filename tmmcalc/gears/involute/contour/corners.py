"""Corners of the contour: two conditions at their limit at once, by Newton's method in (w, x1) for all together.

Where one condition closes the region by itself (both ends of its interval meet) the second equation is that its
derivative along the line of constant sum vanishes.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.model import Values

ROWS = ("room1", "room2", "thickness1", "thickness2", "contact_ratio", "undercut1", "undercut2", "tip1", "tip2")
SLOPE = len(ROWS)  # rows of the derivatives follow those of the values
ROW_OF = {
    "interference1": 0,
    "tolerated1": 0,
    "interference2": 1,
    "tolerated2": 1,
    **{name: i for i, name in enumerate(ROWS) if i > 1},
}
WIDTH = 1e-6  # of the differences that give the derivatives
STEPS = 30
REACH = 0.2  # largest step of x1
EXACT = 1e-11  # of both conditions
LAST = 1e-10  # step of Newton's method below which rounding may be all that is left


def stacked(frame: Frame, w: Values, x1: Values) -> Values:
    """All conditions by ROWS and their derivatives by x1 at constant sum, (18, m)."""
    sums = frame.sums(w)
    x2 = sums.total - x1
    pairs = [frame.room(0, sums, x1), _turned(frame.room(1, sums, x2))]
    pairs += [frame.thickness(0, sums, x1), _turned(frame.thickness(1, sums, x2)), frame.overlap(sums, x1)]
    one = np.ones_like(w)
    pairs += [(x1 - frame.sides[0].least, one), (x2 - frame.sides[1].least, -one)]
    reach = sums.modification + frame.addendum
    pairs += [(reach - x2, one), (reach - x1, -one)]
    return np.vstack([value for value, _ in pairs] + [slope for _, slope in pairs])


def _turned(sloped: tuple[Values, Values]) -> tuple[Values, Values]:
    return sloped[0], -sloped[1]


def equations(one: str, two: str) -> tuple[int, int]:
    """The two rows that vanish where the edges of two conditions meet."""
    first, second = ROW_OF[one], ROW_OF[two]
    if first != second:
        return first, second
    if (
        first < 2 and one != two
    ):  # undercut and interference of one wheel meet where the flank begins on the base circle
        return first, ROW_OF[f"undercut{first + 1}"]
    return first, first + SLOPE


def polish(frame: Frame, w: Values, x1: Values, rows: Values, span: Values) -> tuple[Values, Values, bool]:
    """The corners within ``span`` of w, from (w, x1), (m,), where both ``rows`` (2, m) of `stacked` vanish.

    The last result tells whether all were found.
    """
    m = w.size
    every = np.arange(m)
    residual = last = np.inf
    low, high = w - span, w + span
    for _ in range(STEPS):
        h = WIDTH
        ws = np.concatenate((w, w + h, w - h, w, w))
        xs = np.concatenate((x1, x1, x1, x1 + h, x1 - h))
        found = stacked(frame, ws, xs).reshape(2 * SLOPE, 5, m)[rows, :, every]  # (2, m, 5)
        f = found[..., 0]
        residual = float(np.max(np.abs(f), initial=0.0))
        by_w, by_x = (found[..., 1] - found[..., 2]) / (2 * h), (found[..., 3] - found[..., 4]) / (2 * h)
        determinant = by_w[0] * by_x[1] - by_w[1] * by_x[0]
        determinant = np.where(np.abs(determinant) < 1e-14, 1e-14, determinant)
        step_w = (f[0] * by_x[1] - f[1] * by_x[0]) / determinant
        step_x = (f[1] * by_w[0] - f[0] * by_w[1]) / determinant
        size = max(float(np.max(np.abs(step_w), initial=0.0)), float(np.max(np.abs(step_x), initial=0.0)))
        w, x1 = np.clip(w - step_w, low, high), x1 - np.clip(step_x, -REACH, REACH)
        if not np.isfinite(size):
            return w, x1, False
        settled = size < LAST and size >= last / 2  # only rounding moves the corners
        if size < 1e-13 or settled or (residual < EXACT and size < EXACT):
            return w, x1, residual < EXACT
        last = size
    return w, x1, residual < EXACT
