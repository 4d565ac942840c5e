"""Outlines that a page draws of cubics, and how far one line lies from another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from tmmcalc.core.plane import Plane, Real

ALONG = 40  # places of a cubic that are looked at
CLOSE = 1e-4  # mm


def followed(controls: Plane) -> Plane:
    """Points along cubics that stand end to end: a point, then two controls and the next point each."""
    cubics = np.array([controls[k : k + 4] for k in range(0, len(controls) - 1, 3)])
    t = np.linspace(0, 1, ALONG + 1)[:, None]
    powers = np.hstack([(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3])
    return np.append((cubics @ powers[:-1].T).ravel(), controls[-1])


def far(points: Plane, line: Plane) -> float:
    """How far points (n,) [mm] lie from a line through others (m,) at most; never told less than it is.

    Most lie on a piece of the line beside its nearest vertex; only those that do not are compared with all pieces.
    """
    nearest = KDTree(_columns(line)).query(_columns(points))[1]
    before, after = np.maximum(nearest, 1) - 1, np.minimum(nearest, len(line) - 2)
    away = np.minimum(_distances(points, line, before), _distances(points, line, after))
    rest = away > CLOSE
    if rest.any():
        away[rest] = _distances(points[rest, None], line, np.arange(len(line) - 1)).min(axis=1)
    return float(away.max())


def _distances(points: Plane, line: Plane, piece: NDArray[np.intp]) -> Real:
    """From each of the points to its piece of the line."""
    start, run = line[piece], line[piece + 1] - line[piece]
    way = points - start
    part = np.clip((way * run.conj()).real / np.maximum(np.abs(run) ** 2, 1e-300), 0, 1)
    return np.abs(way - part * run)


def _columns(points: Plane) -> Real:
    return np.column_stack([points.real, points.imag])
