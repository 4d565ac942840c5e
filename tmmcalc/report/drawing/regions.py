"""What of lines lies inside of areas: polylines cut at closed polygons, polygons and arcs cut to a rectangle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from tmmcalc.core.plane import Plane, Real

Edges = tuple[float, float, float, float]  # left, bottom, right and top of a rectangle
NEAR = 1e-9  # parts of a step that are nothing


def contains(loops: Sequence[Plane], z: Plane) -> Real:
    """Whether points (n,) lie inside of any of some closed polygons, by counting crossings; booleans (n,)."""
    found = np.zeros(len(z), bool)
    y = z.imag[:, None]
    for loop in loops:
        a, b = loop, np.roll(loop, -1)
        near = np.maximum(a.imag, b.imag) >= y.min(initial=np.inf)
        near &= np.minimum(a.imag, b.imag) <= y.max(initial=-np.inf)
        a, b = a[near], b[near]
        across = (a.imag > y) != (b.imag > y)
        rise = np.where(across, b.imag - a.imag, 1.0)
        x = a.real + (y - a.imag) / rise * (b.real - a.real)
        found |= np.sum(across & (x > z.real[:, None]), axis=1) % 2 == 1
    return found


def parted(line: Plane, loops: Sequence[Plane]) -> tuple[list[Plane], list[Plane]]:
    """The parts of a polyline (n,) inside of any of some closed polygons, and those outside, each from end to end."""
    points, none = [line[:1]], np.empty((2, 0), complex)
    ends = np.concatenate([none, *(np.stack((loop, np.roll(loop, -1))) for loop in loops)], axis=1)
    for a, b in pairwise(line.tolist()):
        at = np.array([*_cuts(a, b, *ends), 1.0])
        points.append(a + (b - a) * at)
    fine = np.concatenate(points)
    middles: Plane = np.asarray((fine[:-1] + fine[1:]) / 2, complex)
    inside = contains(loops, middles)
    turns = np.flatnonzero(np.diff(inside)) + 1
    found: tuple[list[Plane], list[Plane]] = [], []
    for start, end in pairwise([0, *turns.tolist(), len(inside)]):
        if end > start:
            found[0 if inside[start] else 1].append(fine[start : end + 1])
    return found


def _cuts(a: complex, b: complex, starts: Plane, ends: Plane) -> list[float]:
    """Where a step crosses the sides (m,) of polygons, in parts of its length, from its start on."""
    if a == b:
        return []
    p, q = (starts - a) / (b - a), (ends - a) / (b - a)  # the step lies on x from 0 to 1
    across = (p.imag > 0) != (q.imag > 0)
    p, q = p[across], q[across]
    x = p.real - p.imag / (q.imag - p.imag) * (q.real - p.real)
    return sorted(x[(x > NEAR) & (x < 1 - NEAR)].tolist())


def cut_to(polygon: Plane, box: Edges) -> Plane:
    """The part of a closed polygon in a rectangle, side after side; empty where there is none."""
    left, bottom, right, top = box
    for side, sign, limit in ((1, 1, left), (1, -1, right), (1j, 1, bottom), (1j, -1, top)):
        height = sign * ((polygon / side).real - limit)
        if np.all(height > 0):
            continue
        if not np.any(height > 0):
            return polygon[:0]
        kept: list[complex] = []
        for k, z in enumerate(polygon.tolist()):
            before, last = height[k - 1], complex(polygon[k - 1])
            if (before > 0) != (height[k] > 0):
                kept.append(last + (z - last) * before / (before - height[k]))
            if height[k] > 0:
                kept.append(z)
        polygon = np.array(kept)
    return polygon


def arcs_in(centre: complex, radius: float, box: Edges, start: float, end: float) -> list[tuple[float, float]]:
    """The parts of an arc from angle to angle [rad] that lie in a rectangle, counter-clockwise."""
    left, bottom, right, top = box
    cuts = {start, end}
    for offset, turn in (
        (left - centre.real, 0.0),
        (right - centre.real, 0.0),
        (bottom - centre.imag, math.pi / 2),
        (top - centre.imag, math.pi / 2),
    ):
        if abs(offset) < radius:
            for sense in (-1, 1):
                angle = turn + sense * math.acos(offset / radius)
                first = start + (angle - start) % (2 * math.pi)
                cuts |= {first} if first < end else set()
    found: list[tuple[float, float]] = []
    for low, high in pairwise(sorted(cuts)):
        middle = centre + radius * complex(math.cos((low + high) / 2), math.sin((low + high) / 2))
        if left <= middle.real <= right and bottom <= middle.imag <= top and high > low:
            if found and found[-1][1] == low:
                found[-1] = found[-1][0], high
            else:
                found.append((low, high))
    if len(found) > 1 and found[0][0] == start and found[-1][1] == end and end - start >= 2 * math.pi * (1 - 1e-12):
        first = found.pop()[0]  # what goes on through the angle where the turn begins
        found[0] = first, found[0][1] + 2 * math.pi
    return found
