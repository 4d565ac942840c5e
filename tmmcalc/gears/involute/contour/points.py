"""Points of interest of a contour: C, D and E of the textbook's figures, the deepest point, and lines through it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.involute.contour.bounds import cuts, root
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.form import Sloped
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.strength import tooth_form
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values
from tmmcalc.numerics.roots import Indices, bracketed

ZOOM = 17  # points of a round that narrows a maximum or a root
ROUNDS = 9
NARROWINGS = 16  # of the place of the largest circle
SHRINK = 0.45
EQUAL = 1e-9  # difference of form factors that counts as none
INSIDE = 1e-10  # [rad] below the largest sum, where a line of constant sum still has a part in the region
ASIDE = np.array([-1e-7, 1e-7])  # [rad] from a place that may be a maximum by itself
LEVEL = 1e-15  # of a contact ratio that grows no more


def largest_sum(contour: Contour) -> tuple[float, float]:
    """Point C: the largest x1 + x2, and so the largest reduced radius of curvature, of the main region."""
    region = contour.region
    x1 = float(region.low[-1])
    return x1, float(region.total[-1]) - x1


def largest_contact_ratio(contour: Contour) -> tuple[float, float, float]:
    """Point E: x1, x2 and eps_alpha of the largest contact ratio of the main region."""
    frame, region = contour.frame, contour.region

    def best(low: Values, high: Values, sums: Sums) -> tuple[Values, Values]:
        x1 = np.clip(frame.best_split(sums), low, high)
        return x1, frame.overlap(sums, x1)[0]

    def looked(w: Values) -> tuple[Values, Values]:
        found = cuts(frame, w, tolerated=not contour.strict)
        low, high, _, _ = found.ends(contour.strict)
        x1, ratio = best(low, high, found.sums)
        return x1, np.where(low <= high, ratio, -np.inf)

    w = region.angles
    x1, ratio = best(region.low, region.high, frame.sums(w))
    k = int(np.argmax(ratio))
    if 0 < k < w.size - 1 and np.all(looked(w[k] + ASIDE)[1] < ratio[k]):
        w, x1, ratio, k = w[k : k + 1], x1[k : k + 1], ratio[k : k + 1], 0  # a corner
    for _ in range(ROUNDS):
        if k in (0, w.size - 1) or ratio[k] - min(ratio[k - 1], ratio[k + 1]) < LEVEL:
            break
        w = np.linspace(w[k - 1], w[k + 1], ZOOM)
        x1, ratio = looked(w)
        k = int(np.argmax(ratio))
    sums = frame.sums(w)
    return float(x1[k]), float(sums.total[k] - x1[k]), float(ratio[k]) + frame.task.contact_ratio


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


def strength_split(frame: Frame, sums: Sums, low: Values, high: Values) -> tuple[Values, Values]:
    """x1 (n,) of equal tooth form factors between low and high, and the difference Y_F1 - Y_F2 left there.

    Where no split is equal the end with the smaller difference is given.
    """

    def difference(x1: Values, which: Indices) -> Values:
        return strength_gap(frame, sums.some(which), x1)

    x1 = bracketed(difference, low, high, absolute=1e-12)
    return x1, difference(x1, np.arange(x1.size))


def strength_gap(frame: Frame, sums: Sums, x1: Values) -> Values:
    """Y_F1 - Y_F2 (n,) at x1 on lines of constant sum."""
    one, two = frame.task.first, frame.task.second
    x2 = sums.total - x1
    first = tooth_form(Wheel(one.teeth, x1, one.helix, one.rack), frame.tip(0, sums, x1))
    second = tooth_form(Wheel(two.teeth, x2, two.helix, two.rack), frame.tip(1, sums, x2))
    return first.factor - second.factor


def largest_equal_strength(contour: Contour) -> tuple[float, float] | None:
    """x1, x2 of the largest sum in the main region at which both tooth form factors are equal; None if there is none.

    Upwards the line of equal strength leaves the region through the edge at which the difference changes its sign.
    """
    frame, region = contour.frame, contour.region
    sums = frame.sums(region.angles)
    ends = strength_gap(frame, sums, region.low), strength_gap(frame, sums, region.high)
    holds = np.flatnonzero((ends[0] < 0) != (ends[1] < 0))
    if not holds.size:
        return None
    k = int(holds[-1])
    top = k + 2 == region.angles.size
    if top and abs(float(ends[0][-1])) < EQUAL:
        return largest_sum(contour)  # as of equal wheels
    side = 0 if (ends[0][k] < 0) != (ends[0][k + 1] < 0) else 1

    def edge(w: Values) -> tuple[Sums, Values]:
        found = cuts(frame, w, tolerated=not contour.strict)
        low, high, _, _ = found.ends(contour.strict)
        return found.sums, high if side else low

    at = bracketed(
        lambda w, _: strength_gap(frame, *edge(w)),
        region.angles[k : k + 1],
        region.angles[k + 1 : k + 2] - (INSIDE if top else 0.0),
        absolute=1e-12,
    )
    found, x1 = edge(at)
    return float(x1[0]), float(found.total[0] - x1[0])


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
        inside = _within(contour, points)
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


def _within(contour: Contour, points: Values) -> NDArray[np.bool_]:
    """Whether points (n, 2) lie in the outline: between its ends on their line of constant sum."""
    region = contour.region
    total = points[:, 0] + points[:, 1]
    low = np.interp(total, region.total, region.low)
    high = np.interp(total, region.total, region.high)
    return (total > region.total[0]) & (total < region.total[-1]) & (points[:, 0] > low) & (points[:, 0] < high)
