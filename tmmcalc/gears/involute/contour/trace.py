"""One part of a contour, of one branch, as a closed curve: corners, labelled edges between them, area.

Between its breaks (`breaks`) the edges are smooth, and are traced at Gauss points of phi in w = mean - half cos(phi),
which crowd at the ends as the smooth ends of a region ask.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import UPPER, Cuts, cuts
from tmmcalc.gears.involute.contour.breaks import Break, breaks_of, names_of
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.model import Values

SCAN = 64  # lines of the first scan
TOUCH = np.array([-1e-9, 1e-9])  # [rad]
JOINT = 25  # lines about the place where the tip lines cross
POINTS = 24  # of an edge between two breaks
SNAP = 1e-12  # [rad] difference of angles that is rounding


@record
class Corner:
    """A corner of a contour, and the two lines that meet in it (keys of LINES)."""

    x1: float
    x2: float
    lines: tuple[str, str]


@record
class Edge:
    """A smooth part of a contour, counter-clockwise, with both of its ends."""

    line: str  # key of LINES
    x1: Values  # (n,)
    x2: Values  # (n,)


@record
class ContourPart:
    """A closed region of admissible shifts of one branch."""

    branch: int  # 0: both tip circles outside the reference circles; 1 (2): that of wheel 2 (1) inside; 3: both inside
    corners: tuple[Corner, ...]  # counter-clockwise, from the least sum of shifts
    edges: tuple[Edge, ...]
    area: float
    angles: (
        Values  # (n,) operating angles [rad] of its lines of constant sum, ascending; the first and last are its ends
    )
    total: Values  # (n,) sums of shifts
    low: Values  # (n,) least x1 on each
    high: Values  # (n,) largest x1


def scan(frame: Frame, region: int, also: Sequence[ContourPart] = ()) -> Values:
    """Operating angles [rad] that cover the region, or none; closer where the branches touch.

    ``also``: parts of other branches, which may go on in this one where they end on a tip line.
    """
    near = frame.angle + np.linspace(-0.25, 0.25, 401)
    w = np.sort(np.concatenate((np.linspace(1e-4, 1.5, 600), near[near > 1e-4])))
    sums = frame.sums(w)
    reach = sums.modification + frame.addendum
    good = frame.overlap(sums, frame.best_split(sums))[0] >= 0
    if region in (0, 3):
        good &= (sums.total <= 2 * reach) == (region == 0)
    found = np.flatnonzero(good)
    if not found.size:
        return w[:0]
    left, right = w[max(found[0] - 1, 0)], w[min(found[-1] + 1, w.size - 1)]
    part = np.linspace(-1.0, 1.0, SCAN) ** 3 + 1e-5
    close = frame.angle + np.where(part < 0, frame.angle - left, right - frame.angle) * part
    lines = [np.linspace(left, right, SCAN), close]
    if region == 0:
        lines.append(frame.angle + TOUCH)  # lines of interference have a corner between, which others may cut off
    if frame.neck > 0:  # all branches meet where the tip lines cross, and the necks may end close to it
        end, crossing = frame.joint
        lines.append(end + (crossing - end) * np.linspace(-1.0, 2.0, JOINT))
    shared = [e.x1 + e.x2 for part in also for e in part.edges if e.line in ("tip1", "tip2")]
    lines += [frame.angle_of((total[1:] + total[:-1]) / 2) for total in shared]  # between points: some are corners
    w = np.sort(np.concatenate(lines))
    return w[(w >= left) & (w <= right)]


def parts_of(frame: Frame, region: int, strict: bool, scanned: Cuts, points: int = POINTS) -> tuple[ContourPart, ...]:
    """All closed regions of one branch, by ascending sums; ``points`` of an edge between two breaks."""
    return tuple(_traced(frame, region, strict, part, points) for part in breaks_of(frame, region, strict, scanned))


def _traced(frame: Frame, region: int, strict: bool, breaks: list[Break], points: int) -> ContourPart:
    breaks, edges_w = _snapped(frame, breaks)
    start, end = breaks[0], breaks[-1]
    gauss = rule(points)
    half, mean = np.diff(edges_w) / 2, (edges_w[1:] + edges_w[:-1]) / 2
    inner = mean[:, None] - half[:, None] * np.cos(np.pi * gauss.points)
    w = np.concatenate([np.append(a, row) for a, row in zip(edges_w[:-1], inner, strict=True)] + [edges_w[-1:]])
    found = cuts(frame, w, region, tolerated=not strict)
    low, high, below, above = found.ends(strict)
    low[0] = high[0] = start.x1
    low[-1] = high[-1] = end.x1
    for b in breaks[1:-1]:
        (low if b.side < 0 else high)[np.searchsorted(w, b.w)] = b.x1
    total = found.sums.total
    size = points + 1
    gaps = (high - low)[:-1].reshape(-1, size)[:, 1:] * frame.sum_slope(inner)
    area = float(np.sum(gaps * half[:, None] * np.sin(np.pi * gauss.points) * np.pi * gauss.weights))
    middle = np.arange(half.size) * size + size // 2
    names = [names_of(int(k), region) for k in below[middle] * len(UPPER) + above[middle]]
    lows, highs = [name[0] for name in names], [name[1] for name in names]
    right = _edges(highs, high, total, size)
    left = [Edge(e.line, e.x1[::-1], e.x2[::-1]) for e in reversed(_edges(lows, low, total, size))]
    if right[-1].line == left[0].line:  # one line turns round at the top
        turned = Edge(
            left[0].line, *(np.concatenate((a, b[1:])) for a, b in zip(_xy(right[-1]), _xy(left[0]), strict=True))
        )
        right, left = [*right[:-1], turned], left[1:]
    corners = _corners(frame, breaks, edges_w, lows, highs, low, high, total, size)
    return ContourPart(region, corners, (*right, *left), area, w, total, low, high)


def _xy(edge: Edge) -> tuple[Values, Values]:
    return edge.x1, edge.x2


def _snapped(frame: Frame, breaks: list[Break]) -> tuple[list[Break], Values]:
    """The breaks and the angles between which edges are smooth; breaks at one angle, but for rounding, have the same.

    Between two such angles a line that turns round in a break would be missed by the root of what rounding leaves.
    """
    marks: list[float] = []
    touch = [frame.angle] if breaks[0].w < frame.angle < breaks[-1].w else []  # of the lines of interference
    for w in (*touch, *(b.w for b in breaks)):
        if all(abs(w - mark) > SNAP for mark in marks):
            marks.append(w)
    snapped = [replace(b, w=min(marks, key=lambda mark: abs(mark - b.w))) for b in breaks]
    return snapped, np.array(sorted(marks))


def _edges(names: list[str], x1: Values, total: Values, size: int) -> list[Edge]:
    """Panels of one side joined where they lie on the same line."""
    starts = [0, *(k for k in range(1, len(names)) if names[k] != names[k - 1]), len(names)]
    return [
        Edge(names[a], x1[a * size : b * size + 1], (total - x1)[a * size : b * size + 1]) for a, b in pairwise(starts)
    ]


def _corners(
    frame: Frame,
    breaks: list[Break],
    marks: Values,
    lows: list[str],
    highs: list[str],
    low: Values,
    high: Values,
    total: Values,
    size: int,
) -> tuple[Corner, ...]:
    """Corners in the order of the outline; a smooth end, where one line turns round, is none."""

    def corner(b: Break) -> list[Corner]:
        smooth = b.side == 0 and b.lines[0] == b.lines[1]
        if smooth:
            return []
        s = float(frame.sums(np.array([b.w])).total[0])
        return [Corner(b.x1, s - b.x1, b.lines)]

    inner = list(breaks[1:-1])
    for k in range(1, len(marks) - 1):
        if marks[k] == frame.angle and not frame.neck:
            for names, x1, side, line in ((lows, low, -1, "interference2"), (highs, high, 1, "interference1")):
                if names[k - 1] == names[k] == line:
                    inner.append(Break(frame.angle, float(x1[k * size]), (line, line), side))
    inner.sort(key=lambda b: b.w)
    right = [c for b in inner if b.side > 0 for c in corner(b)]
    left = [c for b in reversed(inner) if b.side < 0 for c in corner(b)]
    return (*corner(breaks[0]), *right, *corner(breaks[-1]), *left)
