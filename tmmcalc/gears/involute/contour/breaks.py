"""Where the lines that bound a region change: found in a scan over the lines of constant sum, narrowed, made exact.

On every line of constant sum two conditions bound the admissible shifts. A change of either is a corner of the region,
a line on which nothing is left its end.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import LOWER, UPPER, Cuts, Kinds, cuts, edge_names
from tmmcalc.gears.involute.contour.corners import ROWS, equations, polish, stacked
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.model import Values

SPLIT = 16  # parts of a narrowed step
TRIES = 5
EMPTY = -1
POINT = 1e-10  # [rad] width of a region that is none
BROKEN = 1e-9  # by which a corner may miss a condition


@record
class Break:
    """Where the edge on one side of a region changes, or the region ends."""

    w: float
    x1: float
    lines: tuple[str, str]
    side: int  # -1: on the side of low x1, 1: of high x1, 0: an end


def breaks_of(frame: Frame, region: int, strict: bool, scanned: Cuts) -> list[list[Break]]:
    """The breaks of all closed regions of one branch, of each by ascending sums."""
    w, kinds = scanned.sums.angle, signatures(scanned, strict)
    changes = np.flatnonzero(kinds[1:] != kinds[:-1])
    if not changes.size:
        return []
    left, right = w[changes], w[changes + 1]
    for n in range(TRIES):
        steps = _narrowed(frame, region, strict, left, right)
        parts = _components(frame, region, strict, steps, n == TRIES - 1)
        if parts is not None:
            return parts
        left, right = np.array([place[:2] for place, _ in steps]).T
    raise AccuracyError(
        "a corner is not found: two lines nearly touch there",
        where="blocking contour",
        remedy="change the least contact ratio or tip thickness slightly",
    )


def signatures(found: Cuts, strict: bool) -> Kinds:
    """One number a line for the pair of conditions that bound it; EMPTY where nothing is left."""
    low, high, below, above = found.ends(strict)
    return np.where(low <= high, below * len(UPPER) + above, EMPTY)


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


def names_of(kind: int, region: int) -> tuple[str, str]:
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
            rough.append(Break(float(place[inner]), x1, names_of(int(kinds[inner]), region), 0))
        else:
            old, new = names_of(int(kinds[0]), region), names_of(int(kinds[1]), region)
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
