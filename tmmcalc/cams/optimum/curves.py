"""The single curves of the blocking contour, for the picture: where each constraint alone is just met.

Their points are roots along the edges of a grid, from the margins at its nodes by a few steps of false position; where
that does not do, because a margin is steep there or jumps, by bracketing. Where a curve bends sharply, points between
them are put in. A margin that jumps (where the follower jams, or the shaft grows by a mm) has no curve.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.forces.kernels import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.march import crossed
from tmmcalc.cams.optimum.margins import NUMBERS
from tmmcalc.cams.optimum.plane import Plane
from tmmcalc.records import record

STEPS = 6  # of false position
MET = 5e-3  # margin on a curve
STEEPEST = 10.0  # beyond a jam a margin says no more than its sign: it counts as so many of that inside
FINEST = 2e-5  # of a cell: bracket of a margin that is steep or jumps
BEND = 0.25  # angle [rad] between two chords, in cells, from which points are put in
ROUNDS = 3  # of putting in
CROSSING = 2  # steps to a point between two
AWAY = 0.5  # of a chord: no point between lies farther from it


@record
class Curve:
    """A stretch of the line on which one constraint is just met."""

    number: int
    start: Values  # (n,) [m]
    roller: Values  # (n,) [m]


def curves(plane: Plane, x: Values, y: Values, held: Values) -> Iterator[Curve]:
    """The curves of all constraints on the grid of x (nx,) and y (ny,) with margins ``held`` (8, nx, ny)."""
    found = [crossed(values) for values in held]
    count = [len(on.inside) for on in found]
    row = np.repeat(np.arange(len(found)), count)
    if not row.size:
        return
    edges = np.concatenate([on.inside for on in found]), np.concatenate([on.outside for on in found])
    points, sound = _points(plane, (x, y), held, edges, row)
    first = np.cumsum(count) - count
    pieces: list[tuple[int, Values]] = []
    for number, on, begin in zip(range(len(found)), found, first.tolist(), strict=True):
        for line in on.lines:
            rows = begin + np.array(line)
            for part in np.split(rows, np.flatnonzero(~sound[rows])):
                kept = part[sound[part]]
                if len(kept) > 1:
                    pieces.append((number, points[:, kept]))
    cell = np.array([[x[1] - x[0]], [y[1] - y[0]]])
    for _ in range(ROUNDS):
        pieces = _refined(plane, pieces, cell)
    for number, at in pieces:
        yield Curve(NUMBERS[number], at[0], at[1])


def _points(
    plane: Plane, nodes: tuple[Values, Values], held: Values, edges: tuple[Indices, Indices], row: Indices
) -> tuple[Values, Mask]:
    """Points (2, n) where margin ``row`` (n,) is 0 on edges from a node inside to one outside, and which are met."""
    inside, outside = edges
    one = np.stack((nodes[0][inside[:, 0]], nodes[1][inside[:, 1]]))
    way = np.stack((nodes[0][outside[:, 0]], nodes[1][outside[:, 1]])) - one
    above, below = held[row, inside[:, 0], inside[:, 1]], held[row, outside[:, 0], outside[:, 1]]
    points, sound = one.copy(), np.zeros(len(row), bool)
    left, low, high = np.arange(len(row)), np.zeros(len(row)), np.ones(len(row))
    for _ in range(STEPS):
        below = np.maximum(below, -STEEPEST * np.maximum(above, MET))
        part = low + (high - low) * above / (above - below)
        points[:, left] = one[:, left] + part * way[:, left]
        value = plane.one(points[:, left], row[left])
        sound[left] = np.abs(value) < MET
        keep, good = np.flatnonzero(np.abs(value) >= MET), value >= 0
        # the end that stays has its value halved (Illinois), so that both ends move
        low, above = np.where(good, part, low)[keep], np.where(good, value, above / 2)[keep]
        high, below = np.where(good, high, part)[keep], np.where(good, below / 2, value)[keep]
        left = left[keep]
        if not left.size:
            return points, sound
    points[:, left] = plane.roots(one[:, left], way[:, left], row[left], FINEST)
    sound[left] = np.abs(plane.one(points[:, left], row[left])) < MET
    return points, sound


def _refined(plane: Plane, pieces: list[tuple[int, Values]], cell: Values) -> list[tuple[int, Values]]:
    """The pieces with points half-way along the chords at sharp bends."""
    chosen = [_bent(at / cell) for _, at in pieces]
    if not any(len(rows) for rows in chosen):
        return pieces
    one = np.concatenate([at[:, rows] for (_, at), rows in zip(pieces, chosen, strict=True)], axis=1)
    other = np.concatenate([at[:, rows + 1] for (_, at), rows in zip(pieces, chosen, strict=True)], axis=1)
    row = np.concatenate([np.full(len(rows), key) for (key, _), rows in zip(pieces, chosen, strict=True)])
    middle, good = between(plane, one / cell, other / cell, row, cell, CROSSING, MET)
    done, first = [], 0
    for (key, at), rows in zip(pieces, chosen, strict=True):
        own = np.arange(first, first + len(rows))[good[first : first + len(rows)]]
        done.append((key, np.insert(at, rows[own - first] + 1, middle[:, own], axis=1)))
        first += len(rows)
    return done


def _bent(at: Values) -> Indices:
    """Numbers of the chords of a line (2, n) that turn sharply against a neighbour, and are not short yet."""
    chord = np.diff(at, axis=1)
    along = chord[0] + 1j * chord[1]
    turn = np.abs(np.angle(along[1:] * np.conj(along[:-1]))) > BEND
    bent = np.append(False, turn) | np.append(turn, False)
    return np.flatnonzero(bent & (np.abs(along) > 0.02))


def between(
    plane: Plane, one: Values, other: Values, row: Indices, cell: Values, steps: int, met: float
) -> tuple[Values, Mask]:
    """Points (2, n) where margin ``row`` (n,) is 0 across the middle of chords in cells (2, n), and which are met.

    By Newton's method on the line across the chord.
    """
    middle, chord = (one + other) / 2, other - one
    across, part, every = np.stack((-chord[1], chord[0])), np.zeros(len(row)), np.arange(len(row))
    for _ in range(steps):
        ends = np.stack((part, part + 1e-4))
        at = (middle[:, None] + ends * across[:, None]) * cell[:, None]
        held = plane.held(*at.reshape(2, -1)).reshape(-1, 2, len(row))[row, :, every].T
        slope = (held[1] - held[0]) / 1e-4
        part = np.clip(part - held[0] / np.where(slope == 0, np.inf, slope), -AWAY, AWAY)
    points = (middle + part * across) * cell
    good: Mask = np.abs(plane.one(points, row)) < met
    return points, good
