"""Linkages that carry a body through poses, from its two points that are pinned: built, rated, ranked."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.synthesis.planar import Bars, bars_of
from tmmcalc.linkage.synthesis.rating import Asked as Limits
from tmmcalc.linkage.synthesis.rating import Rating, rate
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

POOR = math.radians(20)  # least transmission angle without a defect, if none is asked for
CHUNK = 2000  # linkages rated at once
KEPT = 40  # linkages that are looked at closely
MERGED = 0.01  # linkages whose sizes differ by less are one in the list

Rated = tuple[Bars, Rating]  # one linkage, with what is wrong and good about it


def spread(points: Plane) -> float:
    """Largest distance of the points from their middle [m]; 1 where they are one."""
    return float(np.max(np.abs(points - points.mean()))) or 1.0


def pinned(places: Plane, turn: Plane, z1: Plane, c1: Plane, z2: Plane, c2: Plane | None) -> tuple[Bars, Plane, Plane]:
    """Linkages of pins z1, z2 (m,) about c1, c2 (m,), or with z2 on a line; and the places (m, n) of both pins.

    ``places`` (n,) and ``turn`` (m, n) or (1, n) are the poses.
    """
    b, c = places + turn * z1[:, None], places + turn * z2[:, None]
    along = z2 - z1
    length = np.maximum(np.abs(along), 1e-300)
    point = -z1 * np.conj(along) / length
    if c2 is None:
        far = np.argmax(np.abs(c - c[:, :1]), axis=1)
        way = c[np.arange(len(c)), far] - c[:, 0]
        way = way / np.maximum(np.abs(way), 1e-300)
        way = np.where((way.real < -1e-12) | ((np.abs(way.real) <= 1e-12) & (way.imag < 0)), -way, way)
        end, rocker, guide = c[:, 0], np.ones(len(c)), way
    else:
        end, rocker, guide = np.asarray(c2, complex), np.abs(c[:, 0] - c2), np.ones(len(c), complex)
    parts = (c1, np.abs(b[:, 0] - c1), length, end, rocker, guide, point, np.ones(len(c)))
    return bars_of([np.asarray(part)[:, None] for part in parts], c2 is None), b, c


def within(region: tuple[complex, complex] | None, places: Plane) -> np.ndarray:
    """Which places (m,) stand in the region, all if there is none."""
    if region is None:
        return np.ones(len(places), bool)
    low, high = region
    inside = (places.real >= low.real) & (places.real <= high.real)
    return np.asarray(inside & (places.imag >= low.imag) & (places.imag <= high.imag))


def limits(task: SynthesisTask) -> Limits:
    """What `Rating` is asked."""
    asked: PoseTask = task.asked
    return Limits(asked.full_turn, task.transmission or POOR, asked.largest_ratio)


def ranked(task: SynthesisTask, bars: Bars, b: Plane, c: Plane) -> list[Rated]:
    """The best of many linkages by the places (m, n) of their pins, each alone with its rating, without near copies."""
    kept: list[Rated] = []
    for low in range(0, len(b), CHUNK):
        rows = np.arange(low, min(low + CHUNK, len(b)))
        part, rating = rate(bars.rows(rows), b[rows], c[rows])
        order = np.lexsort((-rating.transmission, rating.faults(limits(task))))[: 4 * KEPT]
        kept += [(part.rows(np.array([k])), Rating(*(value[[k]] for value in rating))) for k in order]
    return distinct(best_first(task, kept))


def best_first(task: SynthesisTask, rated: Iterable[Rated]) -> list[Rated]:
    """Fewest defects first; of these the greatest least transmission angle."""
    asked = limits(task)
    return sorted(rated, key=lambda each: (float(each[1].faults(asked)[0]), -float(each[1].transmission[0])))


def distinct(rated: list[Rated]) -> list[Rated]:
    """The first `KEPT` without near copies of those before them."""
    found: list[Rated] = []
    for part, rating in rated:
        if all(_apart(part, other) for other, _ in found):
            found.append((part, rating))
        if len(found) == KEPT:
            break
    return found


def _apart(one: Bars, other: Bars) -> bool:
    mine, yours = (np.array([part.pivot, part.end, part.crank + 0j, part.coupler + 0j]) for part in (one, other))
    return bool(np.max(np.abs(mine - yours)) > MERGED * np.max(np.abs(mine)))
