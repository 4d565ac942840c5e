"""The blocking contour: the closed region of S0 and r2 in which all constraints hold at one height H2.

A grid finds how the region lies; the border is traced to rounding, with the corners where the constraint that binds
changes; ``curves`` are the single constraints around it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.curves import between, curves
from tmmcalc.cams.optimum.plane import Plane, guessed, tamed
from tmmcalc.cams.optimum.results import Contour, Corner, Outline
from tmmcalc.cams.optimum.zerolines import crossed

NEAREST = 1e-6  # of a cell, to the outside of a root: there the constraint that binds is seen
NEWTON = 12
CROSSING = 4  # Newton's steps to a point between two of the border
LAST = 1e-6  # margin from which one step leads to a corner
MET = 1e-11  # margin at a corner
EDGE = 0  # number of a border of the plane itself
WINDOW = 0.45  # of the region's size that the picture shows beyond it


def outlines_of(plane: Plane, x: Values, y: Values, least: Values) -> Iterator[Outline]:
    """The closed borders; beyond the plane nothing is feasible."""
    wide = np.pad(least, 1, constant_values=-1.0)
    x, y = np.pad(x, 1, mode="edge"), np.pad(y, 1, mode="edge")
    on = crossed(wide)
    if not on.lines:
        return
    one = np.stack((x[on.inside[:, 0]], y[on.inside[:, 1]]))
    way = np.stack((x[on.outside[:, 0]], y[on.outside[:, 1]])) - one
    known = guessed(tamed(wide)[None], on.inside, on.outside, np.zeros(len(on.inside), int))
    points, _ = plane.roots(one, way, known)
    binds = np.array(plane.numbers)[np.argmin(plane.held(*(points + NEAREST * way)), axis=0)]
    binds = np.where(np.any(way != 0, axis=0), binds, EDGE)
    cell = np.array([[x[2] - x[1]], [y[2] - y[1]]])
    halves = _halves(plane, points, binds, on.lines, cell)
    corners = _corners(plane, points, binds, on.lines, (x[2] - x[1], y[2] - y[1]))
    for line in on.lines:
        turn = np.diff(points[:, line], axis=1)
        out = way[:, line[:-1]]
        backwards = float(np.sum(turn[0] * out[1] - turn[1] * out[0])) > 0
        yield _outline(points, binds, line[::-1] if backwards else line, corners, halves)


def _halves(
    plane: Plane, points: Values, binds: Indices, lines: list[list[int]], cell: Values
) -> dict[tuple[int, int], complex]:
    """Points of the border half-way between neighbours on the same curve."""
    pairs = [(a, b) for line in lines for a, b in pairwise(line) if binds[a] == binds[b] and binds[a]]
    if not pairs:
        return {}
    one, other = np.array(pairs).T
    row = np.searchsorted(plane.numbers, binds[one])
    at, held, good = between(plane, points[:, one] / cell, points[:, other] / cell, row, cell, CROSSING, MET)
    good &= held.min(axis=0) > -MET
    return {pairs[k]: complex(at[0, k], at[1, k]) for k in np.flatnonzero(good).tolist()}


def _outline(
    points: Values,
    binds: Indices,
    line: list[int],
    corners: dict[tuple[int, int], list[Corner]],
    halves: dict[tuple[int, int], complex],
) -> Outline:
    """One border with its corners put in between its points."""
    x, y, edge, met = [float(points[0, line[0]])], [float(points[1, line[0]])], [], []
    for a, b in pairwise(line):
        for corner in corners.get((a, b), [each.turned for each in reversed(corners.get((b, a), []))]):
            x.append(corner.start)
            y.append(corner.roller)
            edge.append(corner.numbers[0])
            met.append(corner)
        half = halves.get((a, b), halves.get((b, a)))
        if half is not None:
            x.append(half.real)
            y.append(half.imag)
            edge.append(int(binds[b]))
        x.append(float(points[0, b]))
        y.append(float(points[1, b]))
        edge.append(int(binds[b]))
    start, roller = np.array(x), np.array(y)
    area = float(np.sum(start[:-1] * roller[1:] - start[1:] * roller[:-1])) / 2
    return Outline(start, roller, np.array(edge), tuple(met), area)


def _corners(
    plane: Plane, points: Values, binds: Indices, lines: list[list[int]], cell: tuple[float, float]
) -> dict[tuple[int, int], list[Corner]]:
    """Corners between neighbouring points of a border where different constraints bind; two if a third cuts in."""
    changes = [(a, b) for line in lines for a, b in pairwise(line) if binds[a] != binds[b] and binds[a] and binds[b]]
    found: dict[tuple[int, int], list[Corner]] = {}
    if not changes:
        return found
    one, other = np.array(changes).T
    middle = (points[:, one] + points[:, other]) / 2
    place, good, third = _met(plane, middle, binds[one], binds[other], cell)
    for k, pair in enumerate(changes):
        numbers = int(binds[pair[0]]), int(binds[pair[1]])
        if good[k]:
            found[pair] = [Corner(float(place[0, k]), float(place[1, k]), numbers)]
    cut = np.flatnonzero(~good & (third > 0))
    if cut.size:
        sides = [_met(plane, middle[:, cut], own, third[cut], cell) for own in (binds[one][cut], binds[other][cut])]
        for n, k in enumerate(cut.tolist()):
            if sides[0][1][n] and sides[1][1][n]:
                a, b, c = int(binds[one[k]]), int(third[k]), int(binds[other[k]])
                (x1, y1), (x2, y2) = (side[0][:, n].tolist() for side in sides)
                found[changes[k]] = [Corner(x1, y1, (a, b)), Corner(x2, y2, (b, c))]
    return found


def _met(
    plane: Plane, guess: Values, one: Indices, other: Indices, cell: tuple[float, float]
) -> tuple[Values, Mask, Indices]:
    """Points (2, n) where constraints ``one`` and ``other`` (n,) are both just met, near ``guess``.

    Also whether each is a corner, and the number of a constraint that it breaks, 0 for none.
    """
    count, size = guess.shape[1], np.array(cell)
    rows = np.stack((np.searchsorted(plane.numbers, one), np.searchsorted(plane.numbers, other)))
    at, near = guess.copy(), 1e-5 * size
    every = np.arange(count)
    shift = np.array([[0.0, 1, -1, 0, 0], [0, 0, 0, 1, -1]]) * near[:, None]
    for _ in range(NEWTON):
        held = plane.held(*(at[:, :, None] + shift[:, None]).reshape(2, -1)).reshape(len(plane.numbers), count, 5)
        pair = held[rows, every]
        slope = np.stack((pair[..., 1] - pair[..., 2], pair[..., 3] - pair[..., 4])) / (2 * near[:, None, None])
        turn = slope[0, 0] * slope[1, 1] - slope[1, 0] * slope[0, 1]
        turn = np.where(turn == 0, np.inf, turn)
        value = pair[..., 0]
        step = np.stack(
            (value[0] * slope[1, 1] - value[1] * slope[1, 0], value[1] * slope[0, 0] - value[0] * slope[0, 1])
        )
        step = np.clip(step / turn, -size[:, None], size[:, None])
        at = np.maximum(at - step, near[:, None])
        if np.all(np.abs(value) < LAST):
            break
    held = plane.held(*at)
    met = np.all(np.abs(held[rows, every]) < MET, axis=0)
    met &= np.all(np.abs(at - guess) < 3 * size[:, None], axis=0)
    worst = np.argmin(held, axis=0)
    broken = held[worst, every] < -MET
    return at, met & ~broken, np.where(met & broken, np.array(plane.numbers)[worst], 0)


def contour(plane: Plane, seeds: tuple[Values, Values]) -> Contour:
    """The contour of a plane around points S0 (of a rocker R0) and r2 (n,) that are known to be feasible."""
    box = plane.box_of(np.stack(seeds))
    box = plane.limited(box + WINDOW * np.diff(box, axis=1) * np.array([-1.0, 1.0]))
    x, y = np.linspace(box[:, 0], box[:, 1], plane.fine).T
    held = plane.grid(x, y)
    single = tuple(curves(plane, x, y, held))
    (left, right), (low, high) = box.tolist()
    return Contour(plane.height, tuple(outlines_of(plane, x, y, held.min(axis=0))), single, (left, right, low, high))
