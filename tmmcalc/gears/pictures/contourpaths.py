"""The closed curves of a blocking contour: their parts from corner to corner, and smooth curves through them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.contours import Outline, PairContour

BETWEEN = 6  # steps of a picture to one of an outline
SAME = 1e-9  # points that are one


def outlines(pair: PairContour) -> Iterator[Outline]:
    """The closed curves of a pair, strict before tolerated, main regions before pieces."""
    for area in (pair.strict, pair.tolerated):
        if area.main is not None:
            yield area.main
        yield from area.pieces


def paths_of(outline: Outline, key: str) -> Iterator[Plane]:
    """The runs of an outline that lie on a line of the contour, from corner to corner."""
    z, edge = _steps(outline)
    for start, end in _smooth_parts(outline):
        if outline.edges[edge[start]] == key:
            yield z[start : end + 1]


def _steps(outline: Outline) -> tuple[Plane, np.ndarray]:
    """The points (n,) without repeated ones, and the edge of every step (n - 1,)."""
    z = outline.x1 + 1j * outline.x2
    moved = np.abs(np.diff(z)) > 0
    return z[np.append(True, moved)], outline.edge[moved]


def _smooth_parts(outline: Outline) -> Iterator[tuple[int, int]]:
    """First and last points of the parts between corners and changes of the edge."""
    z, edge = _steps(outline)
    sharp = np.zeros(z.size, dtype=bool)
    for corner in outline.corners:
        sharp |= np.abs(z - complex(corner.x1, corner.x2)) < SAME
    sharp[1:-1] |= edge[1:] != edge[:-1]
    sharp[[0, -1]] = True
    yield from pairwise(np.flatnonzero(sharp).tolist())


def smooth(outline: Outline) -> Plane:
    """The closed curve through all points of an outline, with more of them between those of each edge."""
    z, _ = _steps(outline)
    return np.concatenate([_curve(z[a : b + 1])[:-1] for a, b in _smooth_parts(outline)] + [z[-1:]])


def _curve(z: Plane) -> Plane:
    """Cubics through points (n,), each with the tangent of the parabola through its neighbours."""
    if z.size < 3:
        return z
    at = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(z)))))
    tangent = np.gradient(z, at, edge_order=2)
    step, u = np.diff(at)[:, None], np.arange(BETWEEN) / BETWEEN
    one, two = tangent[:-1, None] * step, tangent[1:, None] * step
    start, end = z[:-1, None], z[1:, None]
    rows = start + u * (one + u * (3 * (end - start) - 2 * one - two + u * (one + two - 2 * (end - start))))
    return np.append(rows.ravel(), z[-1])
