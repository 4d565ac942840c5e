"""Points of interest of a contour: C and D of the textbook's figures, the deepest point, and lines through it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.involute.contour.bounds import cuts, root
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.side import Sloped
from tmmcalc.gears.involute.contour.trace import ContourPart
from tmmcalc.gears.model import Values

ZOOM = 65  # points of a round that narrows a root
ROUNDS = 6
NARROWINGS = 16  # of the place of the largest circle
SHRINK = 0.45


def largest_sum(contour: Contour) -> tuple[float, float]:
    """Point C: the largest x1 + x2, and so the largest reduced radius of curvature, of the main region."""
    top = max(contour.region.parts, key=lambda part: float(part.total[-1]))
    x1 = float(top.low[-1])
    return x1, float(top.total[-1]) - x1


def sliding_split(frame: Frame, sums: Sums) -> Values:
    """x1 (n,) of equal specific sliding, theta1(A2) = theta2(A1), on lines of constant sum (line 6)."""
    one, two = frame.sides
    ratio = (frame.task.second.teeth / frame.task.first.teeth) ** 2
    reach = sums.modification + frame.addendum
    # between the shifts at which a tip of the mate reaches the base circle along the line of action, or its own
    inner, outer = (sums.total - reach - side.reference + side.base for side in (one, two))
    low = np.maximum(reach + two.reference - np.hypot(sums.length, two.base), inner)
    high = sums.total - np.maximum(reach + one.reference - np.hypot(sums.length, one.base), outer)

    def difference(some: Sums, x1: Values) -> Sloped:
        first, second = frame.tip(0, some, x1), frame.tip(1, some, some.total - x1)
        rho1 = np.sqrt(np.maximum(first**2 - one.base**2, 1e-24))
        rho2 = np.sqrt(np.maximum(second**2 - two.base**2, 1e-24))
        rise, fall = first / rho1, second / rho2
        start, end = some.length - rho2, some.length - rho1
        value = rho2 * end - ratio * rho1 * start
        return value, -fall * end - rho2 * rise - ratio * (rise * start + rho1 * fall)

    return root(difference, sums, low, high)


def largest_equal_strength(contour: Contour) -> tuple[float, float] | None:
    """x1, x2 of the largest sum in the main region with equal tooth form factors; None if there is none."""
    total, x1 = contour.strength_ends
    if not total.size:
        return None
    k = int(np.argmax(total))
    return float(x1[k]), float(total[k] - x1[k])


def along(f: Callable[[Values], Values], left: float, right: float) -> float:
    """The root of a function between two points of different sign, by rounds of many points at once."""
    for _ in range(ROUNDS):
        w = np.linspace(left, right, ZOOM)
        values = f(w)
        change = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
        if not change.size:
            break
        k = int(change[0])
        left, right = float(w[k]), float(w[k + 1])
    return (left + right) / 2


def equal_sliding(frame: Frame, contact_ratio: float) -> tuple[float, float] | None:
    """Point D: x1, x2 of equal specific sliding at a contact ratio; None if no mesh has both."""
    excess = contact_ratio - frame.task.contact_ratio

    def f(w: Values) -> Values:
        sums = frame.sums(w)
        return frame.overlap(sums, sliding_split(frame, sums))[0] - excess

    w = np.linspace(max(0.5 * frame.angle, 0.02), min(2.5 * frame.angle, 1.2), 64)
    values = f(w)
    change = np.flatnonzero((values[:-1] >= 0) & (values[1:] < 0))
    if not change.size:
        return None
    k = int(change[-1])
    sums = frame.sums(np.array([along(f, float(w[k]), float(w[k + 1]))]))
    x1 = float(sliding_split(frame, sums)[0])
    return x1, float(sums.total[0]) - x1


def deepest(contour: Contour) -> tuple[float, float, float]:
    """x1, x2 of the centre and the radius of the largest circle inside the main region."""
    region = contour.region
    edge1, edge2 = region.outline
    start = np.column_stack((edge1[:-1], edge2[:-1]))
    run = np.column_stack((np.diff(edge1), np.diff(edge2)))
    square = np.maximum(np.sum(run * run, axis=1), 1e-300)
    low, high = start.min(axis=0), start.max(axis=0)
    centre, half, clear = (low + high) / 2, (high - low) / 2, -1.0
    grid = np.linspace(-1, 1, 9)
    for _ in range(NARROWINGS):
        points = centre + half * np.stack(np.meshgrid(grid, grid, indexing="ij"), axis=-1).reshape(-1, 2)
        inside = _within(region.parts, points)
        distance = np.sqrt(np.min(_squares(points, start, run, square), axis=1))
        best = int(np.argmax(np.where(inside, distance, -1.0)))
        if inside[best] and distance[best] >= clear:
            centre, clear = points[best], float(distance[best])
        half = half * SHRINK
        away = np.sqrt(_squares(centre[None], start, run, square)[0])
        # only parts of the outline that may come nearest to a point of the next round
        near = away <= away.min() + 4 * float(np.hypot(*half)) + 1e-12
        start, run, square = start[near], run[near], square[near]
    return float(centre[0]), float(centre[1]), clear


def _squares(points: Values, start: Values, run: Values, square: Values) -> Values:
    """Squares of the distances of points (n, 2) from segments (m, 2), (n, m)."""
    one, two = points[:, 0, None] - start[:, 0], points[:, 1, None] - start[:, 1]
    t = np.clip((one * run[:, 0] + two * run[:, 1]) / square, 0.0, 1.0)
    found: Values = (one - t * run[:, 0]) ** 2 + (two - t * run[:, 1]) ** 2
    return found


def _within(parts: Sequence[ContourPart], points: Values) -> NDArray[np.bool_]:
    """Whether points (n, 2) lie in one of the parts: between its ends on their line of constant sum."""
    x1, total = points[:, 0], points[:, 0] + points[:, 1]
    inside = np.zeros(x1.shape, dtype=bool)
    for part in parts:
        low, high = np.interp(total, part.total, part.low), np.interp(total, part.total, part.high)
        inside |= (total >= part.total[0]) & (total <= part.total[-1]) & (x1 >= low) & (x1 <= high)
    return inside


def held(contour: Contour, w: Values, x1: Values) -> NDArray[np.bool_]:
    """Whether the main region holds x1 (n,) on the lines of operating angles w (n,); exact."""
    inside = np.zeros(w.shape, dtype=bool)
    for part in contour.region.parts:
        low, high, _, _ = cuts(contour.frame, w, part.branch, tolerated=not contour.strict).ends(contour.strict)
        inside |= (w >= part.angles[0]) & (w <= part.angles[-1]) & (x1 >= low) & (x1 <= high)
    return inside
