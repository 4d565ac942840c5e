"""The single curves of the blocking contour, for the picture: where each constraint alone is just met.

Their points are roots along the edges of a grid, the first guess from the margins at its nodes. Where a curve bends
sharply, points between them are put in. A margin that jumps (where the follower jams, or the shaft grows by a mm) has
no curve.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.plane import Plane, guessed, tamed
from tmmcalc.cams.optimum.results import Curve
from tmmcalc.cams.optimum.zerolines import crossed

MET = 5e-3  # margin on a curve
FINEST = 1e-6  # of a cell: bracket of a margin that is steep or jumps
BEND = 0.25  # angle [rad] between two chords, in cells, from which points are put in
ROUNDS = 3  # of putting in
CROSSING = 2  # steps to a point between two
DONE = 1e-11  # margin from which no further step is made
NEAR = 1e-4  # of a chord: first step of the secant
AWAY = 0.5  # of a chord: no point between lies farther from it


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
        yield Curve(plane.numbers[number], at[0], at[1])


def _points(
    plane: Plane, nodes: tuple[Values, Values], held: Values, edges: tuple[Indices, Indices], row: Indices
) -> tuple[Values, Mask]:
    """Points (2, n) where margin ``row`` (n,) is 0 on edges from a node inside to one outside, and which are met."""
    inside, outside = edges
    one = np.stack((nodes[0][inside[:, 0]], nodes[1][inside[:, 1]]))
    way = np.stack((nodes[0][outside[:, 0]], nodes[1][outside[:, 1]])) - one
    points, size = plane.roots(one, way, guessed(tamed(held), inside, outside, row), row, FINEST, MET)
    return points, size <= MET


def _refined(plane: Plane, pieces: list[tuple[int, Values]], cell: Values) -> list[tuple[int, Values]]:
    """The pieces with points half-way along the chords at sharp bends."""
    chosen = [_bent(at / cell) for _, at in pieces]
    if not any(len(rows) for rows in chosen):
        return pieces
    one = np.concatenate([at[:, rows] for (_, at), rows in zip(pieces, chosen, strict=True)], axis=1)
    other = np.concatenate([at[:, rows + 1] for (_, at), rows in zip(pieces, chosen, strict=True)], axis=1)
    row = np.concatenate([np.full(len(rows), key) for (key, _), rows in zip(pieces, chosen, strict=True)])
    middle, _, good = between(plane, one / cell, other / cell, row, cell, CROSSING, MET)
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
) -> tuple[Values, Values, Mask]:
    """Points (2, n) where margin ``row`` (n,) is 0 across the middle of chords in cells (2, n), and which are met.

    By the secant method on the line across the chord; also the margins (8, n) there.
    """
    middle, chord = (one + other) / 2, other - one
    across, every = np.stack((-chord[1], chord[0])), np.arange(len(row))
    part, before = np.zeros(len(row)), np.full(len(row), -NEAR)
    at = middle * cell
    held = plane.held(*np.concatenate(((middle - NEAR * across) * cell, at), axis=1))
    value, last = held[:, len(row) :][row, every], held[:, : len(row)][row, every]
    for _ in range(steps):
        if np.all(np.abs(value) < DONE):
            break
        slope = (value - last) / np.where(part == before, np.inf, part - before)
        before, last = part, value
        part = np.clip(part - value / np.where(slope == 0, np.inf, slope), -AWAY, AWAY)
        at = (middle + part * across) * cell
        held = plane.held(*at)
        value = held[row, every]
    good: Mask = np.abs(value) < met
    return at, held, good
