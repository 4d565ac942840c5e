"""Obstacles: whether a piece of a path or a segment of an arm crosses a polygon, in space a prism.

A piece is cut where it meets the lines (in space the planes) of all faces, in closed form; between two cuts it is
inside or outside as a whole.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.routes import Piece
from tmmcalc.manipulators.task import Obstacle

Flags = NDArray[np.bool_]

NEAR = 1e-12  # of the obstacle's size: what is nearer to its border touches it


def inside(obstacle: Obstacle, p: Values) -> Flags:
    """Whether points (D, n) are inside of an obstacle or on its border."""
    z = p[0] + 1j * p[1]
    corners = np.array(obstacle.corners)
    follow = np.roll(corners, -1)
    size = float(np.max(np.abs(corners - corners[0])))
    a, b = corners[:, None], follow[:, None]
    upright = (a.imag > z.imag) != (b.imag > z.imag)
    with np.errstate(divide="ignore", invalid="ignore"):
        right = z.real < a.real + (z.imag - a.imag) * (b.real - a.real) / (b.imag - a.imag)
    odd = np.count_nonzero(upright & right, axis=0) % 2 == 1
    length = np.abs(b - a)
    # an edge between two corners at one place is that place
    along = np.clip(((z - a) * np.conj(b - a)).real / np.where(length > 0, length, 1.0) ** 2, 0.0, 1.0)
    on_border = np.any(np.abs(z - a - along * (b - a)) <= NEAR * size, axis=0)
    flat = odd | on_border
    return flat if len(p) == 2 else flat & (p[2] >= obstacle.low - NEAR * size) & (p[2] <= obstacle.high + NEAR * size)


def crossed(piece: Piece, obstacle: Obstacle) -> list[tuple[float, float]]:
    """Intervals of the way along a piece [m] that are inside of an obstacle; of no length where it is only touched."""
    cuts = _distinct([0.0, piece.length, *_cuts(piece, obstacle)], piece.length)
    if len(cuts) < 2:
        return [(0.0, 0.0)] if inside(obstacle, piece.at(np.zeros(1))[0])[0] else []
    ends = np.array(cuts)
    within = inside(obstacle, piece.at((ends[1:] + ends[:-1]) / 2)[0])
    touched = inside(obstacle, piece.at(ends)[0])
    return joined([*_runs(cuts, within), *((s, s) for s, on in zip(cuts, touched.tolist(), strict=True) if on)])


def joined(intervals: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Intervals that meet or overlap as one."""
    found: list[tuple[float, float]] = []
    for low, high in sorted(intervals):
        if found and low <= found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], high))
        else:
            found.append((low, high))
    return found


def _runs(cuts: list[float], within: Flags) -> list[tuple[float, float]]:
    return [(a, b) for (a, b), hit in zip(pairwise(cuts), within.tolist(), strict=True) if hit]


def _distinct(cuts: list[float], length: float) -> list[float]:
    kept: list[float] = []
    for s in sorted(cuts):
        if not kept or s - kept[-1] > NEAR * length:
            kept.append(s)
    return kept


def _cuts(piece: Piece, obstacle: Obstacle) -> list[float]:
    """Ways [m] at which a piece meets the lines or planes of all faces."""
    dimensions = len(piece.start)
    faces: list[tuple[Values, float]] = []
    for a, b in zip(obstacle.corners, (*obstacle.corners[1:], obstacle.corners[0]), strict=True):
        normal = np.zeros(dimensions)
        normal[:2] = (a - b).imag, (b - a).real
        faces.append((normal, float(normal[0] * a.real + normal[1] * a.imag)))
    if dimensions == 3:
        up = np.array([0.0, 0.0, 1.0])
        faces += [(up, obstacle.low), (up, obstacle.high)]
    return [s for normal, level in faces for s in _meet(piece, normal, level)]


def _meet(piece: Piece, normal: Values, level: float) -> list[float]:
    """Ways at which normal . p = level."""
    if piece.radius is None or piece.centre is None:
        slope = float(normal @ piece.e1)
        s = (level - float(normal @ piece.start)) / slope if slope else math.inf
        return [s] if 0 <= s <= piece.length else []
    a, b = (piece.radius * float(normal @ e) for e in (piece.e1, piece.e2))
    reach, rest = math.hypot(a, b), level - float(normal @ piece.centre)
    if reach == 0 or abs(rest) > reach * (1 + NEAR):
        return []
    half = math.acos(max(-1.0, min(1.0, rest / reach)))
    found = []
    for theta in (math.atan2(b, a) + half, math.atan2(b, a) - half):
        s = piece.radius * ((piece.sense * (theta - piece.theta)) % (2 * math.pi))
        found += [s] if s <= piece.length else []
    return found


def segment_hits(obstacle: Obstacle, a: Values, b: Values) -> Flags:
    """Whether the segments from a to b (D, n) have a point in an obstacle."""
    flat = np.ones(a.shape[1], bool)
    if len(a) == 3:
        a, b, flat = _between_heights(obstacle, a, b)
    p, q = a[0] + 1j * a[1], b[0] + 1j * b[1]
    corners = np.array(obstacle.corners)
    c, d = corners[:, None], np.roll(corners, -1)[:, None]

    def side(u: NDArray[np.complex128], v: NDArray[np.complex128], w: NDArray[np.complex128]) -> Values:
        return np.asarray(((v - u).conj() * (w - u)).imag)

    crosses = (side(p, q, c) * side(p, q, d) <= 0) & (side(c, d, p) * side(c, d, q) <= 0) & (np.abs(q - p) > 0)
    middle = np.stack((p.real, p.imag))
    ends = inside(Obstacle(obstacle.name, obstacle.corners), middle)
    return flat & (ends | np.any(crosses, axis=0))


def _between_heights(obstacle: Obstacle, a: Values, b: Values) -> tuple[Values, Values, Flags]:
    """The parts of segments between the heights of a prism, and whether there is one."""
    rise = b[2] - a[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = (obstacle.low - a[2]) / rise, (obstacle.high - a[2]) / rise
    level = rise == 0
    among = (a[2] >= obstacle.low) & (a[2] <= obstacle.high)
    first = np.where(level, np.where(among, 0.0, 2.0), np.clip(np.minimum(low, high), 0.0, 2.0))
    last = np.where(level, np.where(among, 1.0, -1.0), np.clip(np.maximum(low, high), -1.0, 1.0))
    there = first <= last
    first, last = np.where(there, first, 0.0), np.where(there, last, 0.0)
    return a + first * (b - a), a + last * (b - a), there
