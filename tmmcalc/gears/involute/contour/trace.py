"""One part of a contour, of one branch, as a closed curve: corners, labelled edges between them, area.

A scan over the lines of constant sum shows which conditions bound the region where. Every change from one line to the
next is narrowed, then the corner in it is found exactly. Between corners the edges are smooth, and are traced at
Gauss points of phi in w = mean - half cos(phi), which crowd at the ends as the smooth ends of a region ask.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tmmcalc.errors import AccuracyError
from tmmcalc.gears.involute.contour.bounds import LOWER, UPPER, Cuts, Kinds, cuts, edge_names
from tmmcalc.gears.involute.contour.corners import ROWS, equations, polish, stacked
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.model import Values
from tmmcalc.numerics.panels import rule
from tmmcalc.records import record

SCAN = 64  # lines of the first scan
TOUCH = np.array([-1e-9, 1e-9])  # [rad]
JOINT = 25  # lines about the place where the tip lines cross
SPLIT = 16  # parts of a narrowed step
TRIES = 5
POINTS = 24  # of an edge between two breaks
EMPTY = -1
POINT = 1e-10  # [rad] width of a region that is none
BROKEN = 1e-9  # by which a corner may miss a condition
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
class Part:
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


@record
class Break:
    """Where the edge on one side of a region changes, or the region ends."""

    w: float
    x1: float
    lines: tuple[str, str]
    side: int  # -1: on the side of low x1, 1: of high x1, 0: an end


def scan(frame: Frame, region: int, also: Sequence[Part] = ()) -> Values:
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


def signatures(found: Cuts, strict: bool) -> Kinds:
    """One number a line for the pair of conditions that bound it; EMPTY where nothing is left."""
    low, high, below, above = found.ends(strict)
    return np.where(low <= high, below * len(UPPER) + above, EMPTY)


def parts_of(frame: Frame, region: int, strict: bool, scanned: Cuts) -> tuple[Part, ...]:
    """All closed regions of one branch, by ascending sums."""
    w, kinds = scanned.sums.angle, signatures(scanned, strict)
    changes = np.flatnonzero(kinds[1:] != kinds[:-1])
    if not changes.size:
        return ()
    left, right = w[changes], w[changes + 1]
    for n in range(TRIES):
        steps = _narrowed(frame, region, strict, left, right)
        parts = _components(frame, region, strict, steps, n == TRIES - 1)
        if parts is not None:
            return tuple(_traced(frame, region, strict, part) for part in parts)
        left, right = np.array([place[:2] for place, _ in steps]).T
    raise AccuracyError(
        "a corner is not found: two lines nearly touch there",
        where="blocking contour",
        remedy="change the least contact ratio or tip thickness slightly",
    )


def _narrowed(frame: Frame, region: int, strict: bool, left: Values, right: Values) -> list[tuple[Values, Kinds]]:
    """Steps of w in which the signature changes, with the signatures and bounds at both ends."""
    parts = np.linspace(0.0, 1.0, SPLIT + 1)[:, None]
    w = left + (right - left) * parts
    low, high, below, above = cuts(frame, w.ravel(), region, tolerated=not strict).ends(strict)
    kinds = np.where(low <= high, below * len(UPPER) + above, EMPTY).reshape(w.shape)
    low, high = low.reshape(w.shape), high.reshape(w.shape)
    found = []
    for column in range(left.size):
        for k in np.flatnonzero(kinds[1:, column] != kinds[:-1, column]):
            at = slice(k, k + 2)
            place = np.concatenate((w[at, column], low[at, column], high[at, column]))
            found.append((place, kinds[at, column]))
    return found


def _names(kind: int, region: int) -> tuple[str, str]:
    """The conditions of a signature."""
    return edge_names(LOWER[kind // len(UPPER)], UPPER[kind % len(UPPER)], region)


def _components(
    frame: Frame, region: int, strict: bool, steps: list[tuple[Values, Kinds]], last: bool
) -> list[list[Break]] | None:
    """The exact breaks of every region, ascending; None if some are not found, or break another condition.

    The latter means that a line which bounds the region between the two was stepped over; ``last``: put up with it.
    """
    rough: list[Break] = []
    spans: list[float] = []
    for place, kinds in steps:
        if EMPTY in kinds:
            inner = 0 if kinds[1] == EMPTY else 1
            x1 = float(place[2 + inner] + place[4 + inner]) / 2
            rough.append(Break(float(place[inner]), x1, _names(int(kinds[inner]), region), 0))
        else:
            old, new = _names(int(kinds[0]), region), _names(int(kinds[1]), region)
            w = float(place[0] + place[1]) / 2
            for k, side in ((0, -1), (1, 1)):
                if old[k] != new[k]:
                    x1 = float(place[2 + 2 * k] + place[3 + 2 * k]) / 2
                    rough.append(Break(w, x1, (old[k], new[k]), side))
        spans += [1.01 * float(place[1] - place[0])] * (len(rough) - len(spans))
    if sum(b.side == 0 for b in rough) % 2:
        return None
    rows = np.array([equations(*each.lines) for each in rough]).T
    places = np.array([(b.w, b.x1) for b in rough]).T
    ws, xs, found = polish(frame, places[0], places[1], rows, np.array(spans))
    if not found or not (last or np.all(_kept(frame, strict, ws, xs) > -BROKEN)):
        return None
    exact = [Break(float(one), float(x), b.lines, b.side) for one, x, b in zip(ws, xs, rough, strict=True)]
    ends = [k for k, b in enumerate(exact) if b.side == 0]
    parts = [sorted(exact[i : j + 1], key=lambda b: b.w) for i, j in zip(ends[::2], ends[1::2], strict=True)]
    wide = [part for part in parts if part[-1].w - part[0].w > POINT]
    # both ends in one point: a line that bounds a tiny region was stepped over, unless it is no more than a point
    return wide if len(wide) == len(parts) or max(spans) < SPLIT * POINT else None


def _kept(frame: Frame, strict: bool, w: Values, x1: Values) -> Values:
    """The least value (m,) of all conditions."""
    rows = [k for k, name in enumerate(ROWS) if not name.startswith("tip" if strict else ("tip", "undercut"))]
    least: Values = np.min(stacked(frame, w, x1)[rows], axis=0)
    return least


def _traced(frame: Frame, region: int, strict: bool, breaks: list[Break]) -> Part:
    breaks, edges_w = _snapped(frame, breaks)
    start, end = breaks[0], breaks[-1]
    gauss = rule(POINTS)
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
    size = POINTS + 1
    gaps = (high - low)[:-1].reshape(-1, size)[:, 1:] * frame.sum_slope(inner)
    area = float(np.sum(gaps * half[:, None] * np.sin(np.pi * gauss.points) * np.pi * gauss.weights))
    middle = np.arange(half.size) * size + size // 2
    names = [_names(int(k), region) for k in below[middle] * len(UPPER) + above[middle]]
    lows, highs = [name[0] for name in names], [name[1] for name in names]
    right = _edges(highs, high, total, size)
    left = [Edge(e.line, e.x1[::-1], e.x2[::-1]) for e in reversed(_edges(lows, low, total, size))]
    if right[-1].line == left[0].line:  # one line turns round at the top
        turned = Edge(
            left[0].line, *(np.concatenate((a, b[1:])) for a, b in zip(_xy(right[-1]), _xy(left[0]), strict=True))
        )
        right, left = [*right[:-1], turned], left[1:]
    corners = _corners(frame, breaks, edges_w, lows, highs, low, high, total, size)
    return Part(region, corners, (*right, *left), area, w, total, low, high)


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
