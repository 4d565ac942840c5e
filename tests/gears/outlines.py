"""Outlines that a page draws of cubics, and how far one line lies from another."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane

ALONG = 40  # places of a cubic that are looked at


def followed(controls: Plane) -> Plane:
    """Points along cubics that stand end to end: a point, then two controls and the next point each."""
    cubics = np.array([controls[k : k + 4] for k in range(0, len(controls) - 1, 3)])
    t = np.linspace(0, 1, ALONG + 1)[:, None]
    powers = np.hstack([(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3])
    return np.append((cubics @ powers[:-1].T).ravel(), controls[-1])


def far(points: Plane, line: Plane) -> float:
    """How far points (n,) lie from a line through others (m,) at most."""
    start, run = line[:-1], np.diff(line)
    way = points[:, None] - start
    part = np.clip((way * run.conj()).real / np.maximum(np.abs(run) ** 2, 1e-300), 0, 1)
    return float(np.abs(way - part * run).min(axis=1).max())
