"""Where an offset of the pitch curve crosses itself, exactly: both angles.

Chords of a fine polygon that cross are the seeds; about each the polygon is drawn again, finer and finer, until the
angles stand still. This needs no slope, which vanishes at cusps and jumps with the curvature; Newton polishes.

A loop between two cusps that are the angle a apart is about a^3 of the base circle long and a^4 wide. Below a = 1e-3
that is near to rounding, in which any two chords may cross: such a loop is told by its angles alone. So near a cusp of
any loop two chords may cross where the curve, which is a point there, does not.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.profile.curvature import Bends, Interval
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Crossing
from tmmcalc.cams.program import TURN

COARSE = 480  # samples of the turn beside those of the panels
ABOUT = 5.0  # half widths about a loop, which hold its own crossing
FINE = 120  # samples there
LEAST_LOOP = 1e-3  # [rad] from cusp to cusp, of a loop whose crossing can be seen
PARTS = 8  # of a chord, pass by pass
PASSES = 36
POLISH = 8
SAME = 1e-9  # [rad] crossings that count as one
CUSP = 0.2  # of the width of a loop: angles about one of its ends that belong to the cusp there
NEIGHBOURS = 1e-7  # [rad] angles of one cusp, no crossing
MEET = 1e-9  # of the base circle: points that are one


def crossings(bends: Bends, distance: float, loops: tuple[Interval, ...]) -> tuple[Crossing, ...]:
    """The crossings of the offset inwards by ``distance``, in the order of their first angles; canonical points."""
    rim, on = bends.rim, bends.panels
    parts = [on.x.ravel(), on.edges[:-1], np.linspace(0.0, TURN, COARSE, endpoint=False)]
    seen = [loop for loop in loops if loop[1] - loop[0] >= LEAST_LOOP]
    parts += [np.mod(_about(loop, np.linspace(-1, 1, FINE)), TURN) for loop in seen]
    phi = np.sort(np.concatenate(parts))
    phi = phi[np.concatenate(([True], np.diff(phi) > 0))]
    for loop in set(loops).difference(seen):
        low, high = _about(loop, np.array([-1.0, 1.0]))
        phi = phi[np.mod(phi - low, TURN) > high - low]
    points = rim.at(phi).offset(distance)
    low, high = phi, np.append(phi[1:], phi[0] + TURN)
    first, second = _crossed(points, np.roll(points, -1))
    found: list[Crossing] = []
    for i, j in zip(first.tolist(), second.tolist(), strict=True):
        one = _refined(rim, distance, (float(low[i]), float(high[i])), (float(low[j]), float(high[j])))
        if one is None or _of_cusp(one, loops):
            continue
        if all(abs(one.first - o.first) + abs(one.second - o.second) > SAME for o in found):
            found.append(one)
    return tuple(sorted(found, key=lambda crossing: crossing.first))


def _about(loop: Interval, at: Values) -> Values:
    """Angles about a loop, at -1 to 1 of what holds its crossing."""
    begin, end = loop
    return np.asarray((begin + end) / 2 + ABOUT * (end - begin) / 2 * at)


def _of_cusp(found: Crossing, loops: tuple[Interval, ...]) -> bool:
    """Whether a crossing lies about one end of a loop, and is much shorter than that."""
    return any(
        found.first < end % TURN < found.second and found.second - found.first < CUSP * (loop[1] - loop[0])
        for loop in loops
        for end in loop
    )


def _crossed(start: Complex, end: Complex) -> tuple[Indices, Indices]:
    """Pairs of chords (i < j) of a closed polygon that cross, neighbours left out."""
    count = len(start)
    i, j = np.nonzero(_cross(start, end, start, end))
    apart = (j - i > 1) & (j - i < count - 1)
    return i[apart], j[apart]


def _cross(a: Complex, b: Complex, c: Complex, d: Complex) -> np.ndarray:
    """Whether the chords a to b (m,) cross the chords c to d (n,), (m, n)."""
    one, other = (b - a)[:, None], (d - c)[None]
    gap = c[None] - a[:, None]
    area = (np.conj(one) * other).imag
    with np.errstate(divide="ignore", invalid="ignore"):
        along, across = (np.conj(gap) * other).imag / area, (np.conj(gap) * one).imag / area
        return (area != 0) & (along >= 0) & (along <= 1) & (across >= 0) & (across <= 1)


def _refined(rim: Rim, distance: float, one: Interval, other: Interval) -> Crossing | None:
    """The crossing near two chords; None if they belong to the point of a cusp, or only nearly meet."""
    for _ in range(PASSES):
        a, b = (np.linspace(2 * lo - hi, 2 * hi - lo, PARTS + 1) for lo, hi in (one, other))
        p, q = rim.at(a).offset(distance), rim.at(b).offset(distance)
        i, j = np.nonzero(_cross(p[:-1], p[1:], q[:-1], q[1:]))
        if not i.size:
            break
        one, other = (float(a[i[0]]), float(a[i[0] + 1])), (float(b[j[0]]), float(b[j[0] + 1]))
    at, gap = _polished(rim, distance, (sum(one) / 2, sum(other) / 2))
    first, second = sorted(angle % TURN for angle in at)
    if second - first < NEIGHBOURS or gap > MEET * rim.follower.base:
        return None
    point = rim.at(np.array([first])).offset(distance)[0]
    return Crossing(first, second, complex(point))


def _polished(rim: Rim, distance: float, now: Interval) -> tuple[Interval, float]:
    """Newton on both points being one; kept only while it closes in. The angles and the gap that is left."""
    best, gap = now, np.inf
    for _ in range(POLISH):
        ends = rim.at(np.array(now))
        points, rates = ends.offset(distance), ends.rate(distance, rim.flat)
        rest = complex(points[0] - points[1])
        if abs(rest) >= gap:
            break
        best, gap = now, abs(rest)
        area = float((np.conj(rates[0]) * rates[1]).imag)
        if area == 0:
            break
        by = float((np.conj(rest) * rates[1]).imag) / area, float((np.conj(rest) * rates[0]).imag) / area
        now = (now[0] - by[0], now[1] - by[1])
    return best, gap
