"""The plane of S0 and r2 at one height H2: margins over it, the box that holds the region, roots along edges.

Of a rocker it is that of R0 and r2 at one l0 and l2.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.margins import NUMBERS, SLACK, margins
from tmmcalc.cams.optimum.rockersizes import NUMBERS as ROCKER_NUMBERS
from tmmcalc.cams.optimum.rockersizes import RockerScene, Sizes, judge_rocker, start_angle
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.core.numerics.roots import bracketed

COARSE = 9  # nodes a side that show where the region lies
GROWTH = 0.6  # of its size by which the box grows where the region goes on
ROUNDS = 14
LEAST = 1e-3  # of the way from an end to a first guess


def tamed(margin: Values) -> Values:
    """A margin, 1 - value/limit, for root finders: where it is negative, limit/value - 1.

    Towards where the follower jams, the value grows without limit; this goes on almost straight, to -1.
    """
    found: Values = margin / (1 - np.minimum(margin, 0.0))
    return found


def guessed(held: Values, inside: Indices, outside: Indices, row: Indices) -> tuple[Values, Values, Values]:
    """Values (n,) at both ends of edges (n, 2) of a grid, and where between them functions (f, nx, ny) pass 0.

    ``row`` (n,) are the functions that are meant. The guess is by the second differences along the edge.
    """
    bend = np.zeros((2, *held.shape))
    bend[0, :, 1:-1] = held[:, 2:] - 2 * held[:, 1:-1] + held[:, :-2]
    bend[1, :, :, 1:-1] = held[:, :, 2:] - 2 * held[:, :, 1:-1] + held[:, :, :-2]
    one, other = (row, inside[:, 0], inside[:, 1]), (row, outside[:, 0], outside[:, 1])
    along = (inside[:, 0] == outside[:, 0]).astype(int)
    above, below, bent = held[one], held[other], (bend[along, *one] + bend[along, *other]) / 4
    fall = np.where(above > below, above - below, 1.0)
    part = above / fall
    slope = -fall + bent * (2 * part - 1)
    return above, below, part - bent * part * (part - 1) / np.where(slope < 0, slope, -fall)


class Plane:
    """The plane of S0 and r2 at one height."""

    numbers = NUMBERS  # of the constraints, in the order of the margins
    fine = 27  # nodes a side that show the border of the region

    def __init__(self, scene: Scene, height: float) -> None:
        self.scene, self.height = scene, height
        room = height - scene.stroke - scene.guide.gap
        self.outer = np.array([[1e-3 * room, room], [1e-3 * room, room]])

    def held(self, x: Values, y: Values) -> Values:
        """Margins (8, n)."""
        return margins(self.scene, x, y, np.full(len(x), self.height))

    def one(self, at: Values, row: Indices) -> Values:
        """The margin of row (n,) at points (2, n)."""
        found: Values = margins(self.scene, at[0], at[1], np.full(len(row), self.height), row)[row, np.arange(len(row))]
        return found

    def grid(self, x: Values, y: Values) -> Values:
        """Margins (8, nx, ny)."""
        found = self.held(np.repeat(x, len(y)), np.tile(y, len(x)))
        return found.reshape(len(found), len(x), len(y))

    def limited(self, box: Values) -> Values:
        """The part of a box (2, 2) that belongs to the plane."""
        return np.clip(box, self.outer[:, :1], self.outer[:, 1:])

    def box_of(self, seeds: Values) -> Values:
        """A box (2, 2) that just holds the region around the seeds (2, n)."""
        low, high = seeds.min(axis=1), seeds.max(axis=1)
        size = np.maximum(high - low, 0.01 * self.outer[:, 1])
        box = self.limited(np.stack((low - size / 2, high + size / 2), axis=1))
        for _ in range(ROUNDS):
            x, y = np.linspace(box[:, 0], box[:, 1], COARSE).T
            good = np.all(self.grid(x, y) >= 0, axis=0)
            ends = np.array([[good[0].any(), good[-1].any()], [good[:, 0].any(), good[:, -1].any()]])
            grown = self.limited(box + GROWTH * np.diff(box, axis=1) * np.where(ends, [-1.0, 1.0], 0.0))
            if np.array_equal(grown, box):
                return self._tight(x, y, good, seeds)
            box = grown
        return box

    def _tight(self, x: Values, y: Values, good: Values, seeds: Values) -> Values:
        """The box of the good nodes and the seeds, a cell wider."""
        rows, columns = np.flatnonzero(good.any(axis=1)), np.flatnonzero(good.any(axis=0))
        sides = []
        for nodes, which, own in ((x, rows, seeds[0]), (y, columns, seeds[1])):
            cell = nodes[1] - nodes[0]
            held = np.concatenate((nodes[which], own))
            sides.append([held.min() - cell, held.max() + cell])
        return self.limited(np.array(sides))

    def roots(
        self,
        one: Values,
        way: Values,
        known: tuple[Values, Values, Values],
        row: Indices | None = None,
        near: float = 0.0,
        met: float = SLACK,
    ) -> tuple[Values, Values]:
        """Points (2, n) between ``one``, which is inside, and ``one`` + ``way`` (2, n), which is outside.

        ``row`` (n,) are the margins that are meant, None the least of all; ``known`` their values (n,) at both, tamed,
        and first guesses as parts of the way. Good is an error of ``near``, as a part of the way, or a margin of
        ``met``. Also the sizes (n,) of the margins at the points.
        """
        rows = np.flatnonzero(np.any(way != 0, axis=0))
        size = np.minimum(np.abs(known[0]), np.abs(known[1]))

        def margin(part: Values, which: Indices) -> Values:
            own = rows[which]
            at = one[:, own] + part * way[:, own]
            found: Values = self.held(*at).min(axis=0) if row is None else self.one(at, row[own])
            size[own] = np.minimum(size[own], np.abs(found))
            return tamed(found)

        part = np.zeros(one.shape[1])
        values, guess = (known[0][rows], known[1][rows]), np.clip(known[2][rows], LEAST, 1 - LEAST)
        part[rows] = bracketed(
            margin,
            np.zeros(len(rows)),
            np.ones(len(rows)),
            absolute=near,
            known=(*values, guess),
            level=met / (1 + met),
        )
        return one + part * way, size


class RockerPlane(Plane):
    """The plane of R0 and r2 of a rocker at one l0 and l2.

    The room at the pivot asks for an r2 that grows with R0, along which the region lies as a narrow band. So y, in
    place of r2, is what r2 has beyond that, and a length that keeps it positive.
    """

    numbers = ROCKER_NUMBERS
    fine = 65  # where two constraints close the band it runs out in a point

    def __init__(self, of: RockerScene, rocker: float, centres: float) -> None:
        self.of, self.rocker, self.height = of, rocker, centres
        near, far = abs(centres - rocker), centres + rocker
        self.outer = np.array([[near + 1e-3 * (far - near), far], [1e-3 * far, far]])

    def held(self, x: Values, y: Values) -> Values:
        """Margins (8, n)."""
        one = np.ones(len(x))
        return judge_rocker(self.of, Sizes(self.rocker * one, x, self.roller(x, y), self.height * one)).margin

    def one(self, at: Values, row: Indices) -> Values:
        """The margin of row (n,) at points (2, n)."""
        found: Values = self.held(at[0], at[1])[row, np.arange(len(row))]
        return found

    def roller(self, x: Values, y: Values) -> Values:
        """r2 (n,) of points."""
        return y + self._passing(x)

    def beyond(self, x: Values, roller: Values) -> Values:
        """y (n,) of R0 and r2."""
        return roller - self._passing(x)

    def _passing(self, x: Values) -> Values:
        """r2 at y = 0: what passes the pivot, less a length that no r2 falls short of it by."""
        one = np.ones(np.shape(x))
        start, _ = start_angle(Sizes(self.rocker * one, x, 0 * one, self.height * one))
        square = self.height**2 + self.rocker**2 - 2 * self.height * self.rocker * np.cos(start + self.of.top)
        return np.sqrt(square) - 2 * self.height
