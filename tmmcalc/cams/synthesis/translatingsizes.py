"""Translating roller follower: S0 and e under limits of the pressure angle, in closed form.

|S' + e| <= t (S0 + dS) at every phi of a phase, t = tan[theta], is a pair of half planes with the same two directions
all over the phase. So of each pair one line counts, that of the largest height:

    S0 >= +e/t + max(S'/t - dS),      S0 >= -e/t + max(-S'/t - dS)

on the rise and the same on the return: the admissible region lies above at most four lines.
"""

from __future__ import annotations

from itertools import combinations
from math import acos, atan, cos, hypot, pi, sin, sqrt, tan

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import limited_phases
from tmmcalc.cams.synthesis.polygon import polygon
from tmmcalc.cams.synthesis.results import PLANE, Region
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record

NEAR = 1e-12  # relative: a point this near to a line lies on it
NOISE = 1e-14  # of S0: an offset that is rounding
WINDOW = 2.0  # height of the window against the S0 taken


@record
class Line:
    """S0 >= slope e + height: theta reaches its limit with the sign ``side`` at ``phi``."""

    slope: float
    height: float  # [m]
    side: int
    phi: float  # [rad]

    def at(self, e: float) -> float:
        """The least S0 at e."""
        return self.slope * e + self.height


Lines = tuple[Line, ...]
Point = tuple[float, float]  # e, S0


def lines_of(task: CamTask) -> Lines:
    """The lines of rise and return, exact: heights are extremes over phi."""
    found = []
    for _, limit, part, (y, y1) in limited_phases(task):
        t, sides = tan(limit), (1, -1)
        heights = part.extremes_of(np.stack([side * y1 / t - y for side in sides]))
        found += [Line(side / t, height, side, phi) for side, (_, (height, phi)) in zip(sides, heights, strict=True)]
    return tuple(found)


def least_start(lines: Lines, e: float) -> float:
    """Least S0 at the offset e [m]."""
    return max(line.at(e) for line in lines)


def lowest(lines: Lines) -> Point:
    """e, S0 of the least S0: of all pairs of a rising and a falling line the highest crossing."""
    corners = [_crossing(a, b) for a in lines for b in lines if a.slope > 0 > b.slope]
    return max(corners, key=lambda corner: corner[1])


def nearest(lines: Lines) -> Point:
    """e, S0 of the least base circle: the point of the region nearest to the origin, a corner or a foot."""
    points = [_foot(line) for line in lines]
    points += [_crossing(a, b) for a, b in combinations(lines, 2) if a.slope != b.slope]
    inside = [(e, s) for e, s in points if s >= least_start(lines, e) - NEAR * abs(s)]
    return min(inside, key=lambda point: hypot(*point))


def offset_at_start(lines: Lines, start: float) -> float:
    """The smallest offset [m] that keeps the limits with this S0; raises `NoSolutionError` if there is none."""
    low = max((line.height - start) / -line.slope for line in lines if line.slope < 0)
    high = min((start - line.height) / line.slope for line in lines if line.slope > 0)
    if low > high:
        raise _too_small("S0", start, lowest(lines)[1], "start_distance")
    return min(max(0.0, low), high)


def offset_on_base(lines: Lines, base: float) -> float:
    """The smallest offset [m] that keeps the limits with this R0; raises `NoSolutionError` if there is none.

    On the circle e = R0 sin(a), S0 = R0 cos(a) every line leaves an interval of a.
    """
    low, high = -pi / 2, pi / 2
    for line in lines:
        reach = line.height / (base * sqrt(1 + line.slope**2))
        lean = atan(line.slope)
        if reach > 1:
            low, high = pi, -pi
            break
        half = acos(max(reach, -1.0))
        low, high = max(low, -lean - half), min(high, -lean + half)
    if low > high:
        raise _too_small("R0", base, hypot(*nearest(lines)), "base_radius")
    return base * sin(min(max(0.0, low), high))


def offset_of(lines: Lines, base: float, start: float) -> float:
    """e [m] of a given R0 and S0: of the two signs the one with more room; raises `NoSolutionError` if R0 < S0."""
    if base < start:
        raise NoSolutionError(
            f"R0 = {1e3 * base:g} mm is less than S0 = {1e3 * start:g} mm: R0^2 = S0^2 + e^2",
            where="cam_synthesis",
            value=base,
            limit=start,
            remedy="leave base_radius or start_distance out",
        )
    e = sqrt((base - start) * (base + start))
    return min(e, -e, key=lambda x: least_start(lines, x))


def start_on_base(base: float, e: float) -> float:
    """S0 [m] of a given R0 and e; raises `NoSolutionError` if |e| >= R0."""
    if base <= abs(e):
        raise NoSolutionError(
            f"the base circle of {1e3 * base:g} mm does not reach beyond the offset of {1e3 * abs(e):g} mm",
            where="cam_synthesis",
            value=base,
            limit=abs(e),
            remedy="a larger base_radius or a smaller offset",
        )
    return sqrt((base - abs(e)) * (base + abs(e)))


def region_of(lines: Lines, taken: Point) -> Region:
    """The region above the lines, cut at a height above the point taken."""
    top = WINDOW * max(taken[1], lowest(lines)[1])
    slope = np.array([line.slope for line in lines])
    length = np.hypot(slope, 1.0)
    normal = np.append((slope - 1j) / length, 1j)
    bound: Values = np.append(-np.array([line.height for line in lines]) / length, top)
    corners, ring = polygon(normal, bound)
    x, y = corners.real, corners.imag.copy()
    phi = np.array([*(line.phi for line in lines), 0.0])
    side = np.array([*(line.side for line in lines), 0], dtype=np.intp)
    return Region(PLANE, np.where(np.abs(x) <= NOISE * np.abs(y), 0.0, x), y, phi[ring], side[ring])


def textbook(task: CamTask, e: float | None) -> Point:
    """e, S0 as if the limits were reached where the velocity is largest (5.44).

    With different limits, or different strokes there, the lines through these two points cross at e; on a free
    return e is 0. ``e``: prescribed.
    """
    tops = velocity_tops(task)
    if e is None:
        e = 0.0
        if len(tops) > 1:
            (t2, y2, v2), (t4, y4, v4) = tops
            e = (y2 - y4 + v4 / t4 - v2 / t2) / (1 / t2 + 1 / t4)
    heights = [(v + side * e) / t - y for side, (t, y, v) in zip((1, -1), tops, strict=False)]
    return clean((e, max(heights)))


def velocity_tops(task: CamTask) -> list[tuple[float, float, float]]:
    """tan[theta], dS and |S'| where S' is largest on the rise and smallest on the return."""
    tops = []
    for kind, limit, part, (y, y1) in limited_phases(task):
        speed, phi = part.extremes(y1 if kind == "rise" else -y1)[1]
        tops.append((tan(limit), float(part.at(y, np.array([phi]))[0]), speed))
    return tops


def clean(point: Point) -> Point:
    """The point without an offset that is rounding.

    >>> clean((-8e-18, 0.05)), clean((1e-9, 0.05))
    ((0.0, 0.05), (1e-09, 0.05))
    """
    e, start = point
    return (0.0 if abs(e) <= NOISE * abs(start) else e), start


def _crossing(a: Line, b: Line) -> Point:
    e = (b.height - a.height) / (a.slope - b.slope)
    return clean((e, (a.slope * b.height - b.slope * a.height) / (a.slope - b.slope)))


def _foot(line: Line) -> Point:
    lean = cos(atan(line.slope))
    return -line.slope * line.height * lean * lean, line.height * lean * lean


def _too_small(symbol: str, value: float, least: float, name: str) -> NoSolutionError:
    return NoSolutionError(
        f"no offset keeps the pressure angle with {symbol} = {1e3 * value:g} mm; the least is {1e3 * least:.6g} mm",
        where="cam_synthesis",
        value=value,
        limit=least,
        remedy=f"a larger {name}, a larger pressure_angle, or longer phases",
    )
