"""Where the pieces of a sheet stand: columns from left to right, in each rows from the top, in each row side by side.

Every such arrangement keeps the order of the pieces. A column is as wide, and a row as high, as its share of the area
that its pieces would like to have, but never less than they need. Of the arrangements that give every piece what it
needs that one is taken in which widths and heights are nearest to the good ones, all to one scale, see `measure`; its
columns are made wider and narrower as long as that helps. Corners that a title block takes stay free.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from heapq import nsmallest
from itertools import islice, product
from typing import NamedTuple

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import LEADING, width, wrapped
from tmmcalc.report.sheets.piece import Piece

GAP = 6.0  # between pieces [mm]
UNDER = 4.0  # from a heading to its picture [mm]
TRIED = 50  # arrangements that are laid out in full, the most promising ones
MOST = 400  # and so many until one is found that gives every piece what it needs
FULL = 1.05  # part of the room beyond which the needs of pieces, with gaps also beside the last ones, cannot be met
KEPT = 8  # ways to divide one column that are joined with others
FINALISTS = 5  # of these the columns are made wider and narrower
STEPS = (0.2, 0.05)
EPS = 1e-9  # [mm]

Row = tuple[int, int]  # from piece to piece, the last one not included
Column = tuple[Row, ...]


class Room(NamedTuple):
    """What a frame leaves to the pieces: a rectangle without two of its corners, each with what keeps clear of it."""

    box: Box
    block: tuple[float, float] = (0.0, 0.0)  # width and height taken in the lower right corner
    corner: tuple[float, float] = (0.0, 0.0)  # in the upper left corner

    def floor(self, right: float) -> float:
        """How far down a rectangle reaches whose right side is there."""
        return self.box.bottom + (self.block[1] if right > self.box.right - self.block[0] + EPS else 0.0)

    @property
    def area(self) -> float:
        """Its area [mm^2]."""
        return self.box.width * self.box.height - self.block[0] * self.block[1]


class Place(NamedTuple):
    """The place of a piece: lines of its heading, centred under ``head`` [mm], and the rectangle for the picture."""

    piece: Piece
    heading: tuple[str, ...]
    head: complex
    box: Box


class _Way(NamedTuple):
    """A way to lay an arrangement out."""

    columns: tuple[Column, ...]
    shares: list[float]  # of the columns
    snapped: int  # the columns from this one on are as wide together as the title block; 0: as they come
    stops: bool  # whether last rows end before the title block, where they could stand over it

    def changed(self, step: float) -> Iterator[_Way]:
        """The way with one share larger or smaller by this part."""
        for k, factor in product(range(len(self.shares)), (1 + step, 1 / (1 + step))):
            yield self._replace(shares=[share * (factor if k == j else 1.0) for j, share in enumerate(self.shares)])


class Layout(NamedTuple):
    """Places of all pieces, the measure of how far they are from what these would like, and how they came there."""

    places: tuple[Place, ...]
    cost: float
    way: _Way


def arranged(pieces: Sequence[Piece], room: Room, height: float) -> Layout | None:
    """The best arrangement with headings of this height [mm]; None if the pieces do not fit together."""
    task = _Task(pieces, room, height)
    if sum((w + GAP) * (h + GAP + task.head) for w, h in (piece.least for piece in pieces)) > FULL * room.area:
        return None
    found = [*filter(None, map(task.layout, task.promising(TRIED)))]
    if not found:
        found = [*islice(filter(None, map(task.layout, task.promising(MOST)[TRIED:])), 1)]
    best = [task.improved(each) for each in nsmallest(FINALISTS, found, key=lambda each: each.cost)]
    return min(best, key=lambda each: each.cost, default=None)


class _Task:
    """Pieces and the room for them."""

    def __init__(self, pieces: Sequence[Piece], room: Room, height: float) -> None:
        self.pieces, self.room, self.height = pieces, room, height
        self.head = height * 1.25 + UNDER  # what a heading of one line takes

    @cached_property
    def wanted(self) -> list[tuple[float, float]]:
        """Good widths and heights of the pieces with their headings, all to the scale that fills the room."""
        good = [piece.good for piece in self.pieces]
        scale = math.sqrt(self.room.area / sum((w + GAP) * (h + GAP + self.head) for w, h in good))
        return [(w * scale, h * scale) for w, h in good]

    @cached_property
    def areas(self) -> list[float]:
        """What of the room each piece would like to have."""
        return [(w + GAP) * (h + GAP + self.head) for w, h in self.wanted]

    # which arrangements are worth to be laid out

    def promising(self, count: int) -> list[tuple[Column, ...]]:
        """The ``count`` best arrangements where shares of areas alone are counted, not corners and what is needed."""
        best: list[list[tuple[float, tuple[Column, ...]]]] = [[(0.0, ())]]
        total = len(self.pieces)
        for end in range(1, total + 1):
            ways: list[tuple[float, tuple[Column, ...]]] = []
            for begin in range(end):
                columns = self.columns(begin, end)
                ways += [(a + b, (*left, column)) for a, left in best[begin] for b, column in columns]
                ways = nsmallest(count, ways)
            best.append(ways)
        return [columns for _, columns in best[total]]

    def columns(self, begin: int, end: int) -> list[tuple[float, Column]]:
        """The best columns of these pieces, with their costs."""
        wide = self.room.box.width * sum(self.areas[begin:end]) / sum(self.areas)
        best: list[list[tuple[float, Column]]] = [[(0.0, ())]]
        for last in range(begin + 1, end + 1):
            ways = [
                (cost + self.row_cost((first, last), wide), (*rows, (first, last)))
                for first in range(begin, last)
                for cost, rows in best[first - begin]
            ]
            best.append(nsmallest(KEPT, ways))
        return best[-1]

    def row_cost(self, row: Row, wide: float) -> float:
        """The measure of a row in a column of this width, of the height that its area gives."""
        first, last = row
        high = sum(self.areas[first:last]) / wide - GAP - self.head
        across = wide - GAP * (last - first)
        share = across / sum(w for w, _ in self.wanted[first:last])
        if high <= 0 or across <= 0:
            return math.inf
        return sum(measure(share, high / h) for _, h in self.wanted[first:last])

    # laying one out

    def layout(self, columns: tuple[Column, ...]) -> Layout | None:
        """Places in an arrangement, the best of its ways; None where a piece would have less than it needs."""
        shares = [sum(self.areas[column[0][0] : column[-1][1]]) for column in columns]
        ways = (_Way(columns, shares, snapped, stops) for snapped in range(len(columns)) for stops in (False, True))
        return min(filter(None, map(self.laid, ways)), key=lambda each: each.cost, default=None)

    def improved(self, layout: Layout) -> Layout:
        """The layout with columns made wider and narrower as long as that brings it nearer."""
        for step in STEPS:
            better: Layout | None = layout
            while better is not None:
                layout = better
                tried = map(self.laid, layout.way.changed(step))
                found = min(filter(None, tried), key=lambda each: each.cost, default=layout)
                better = found if found.cost < layout.cost * (1 - EPS) else None
        return layout

    def laid(self, way: _Way) -> Layout | None:
        """Places in one way to lay an arrangement out; None where it is none."""
        left, right = self.room.box.left, self.room.box.right
        edge = right - self.room.block[0]
        if (way.snapped or way.stops) and not left < edge < right:
            return None
        groups = [(0, len(way.columns), left, right)]
        if way.snapped:
            groups = [(0, way.snapped, left, edge), (way.snapped, len(way.columns), edge + GAP, right)]
        needs = [max(self.across(row) for row in column) for column in way.columns]
        places: list[Place] = []
        for first, last, begin, end in groups:
            widths = shared(way.shares[first:last], needs[first:last], end - begin - GAP * (last - first - 1))
            if widths is None:
                return None
            at = begin
            for column, wide in zip(way.columns[first:last], widths, strict=True):
                found = self.column(column, at, at + wide, edge if way.stops else right)
                if found is None:
                    return None
                places += found
                at += wide + GAP
        return Layout(tuple(places), self.cost(places), way)

    def across(self, row: Row) -> float:
        """The least width of a row."""
        return sum(piece.least[0] for piece in self.pieces[slice(*row)]) + GAP * (row[1] - row[0] - 1)

    def column(self, column: Column, left: float, right: float, limit: float) -> list[Place] | None:
        """Places in a column, whose last row does not go beyond ``limit``."""
        box, last = self.room.box, len(column) - 1
        ends = [right if k < last else min(right, limit) for k in range(len(column))]
        rows = [self.row(row, left, end) for row, end in zip(column, ends, strict=True)]
        needs, shares = [], []
        for k, (row, sides) in enumerate(zip(column, rows, strict=True)):
            if sides is None:
                return None
            pieces = self.pieces[slice(*row)]
            lost = [
                self.above(piece, a, b, k == 0) + (self.room.floor(b) - box.bottom if k == last else 0.0)
                for piece, (a, b) in zip(pieces, sides, strict=True)
            ]
            needs.append(max(piece.least[1] + high for piece, high in zip(pieces, lost, strict=True)))
            shares.append(sum(self.areas[slice(*row)]) / (ends[k] - left) + max(lost) / 2)
        heights = shared(shares, needs, box.height - GAP * last)
        if heights is None:
            return None
        found, top = [], box.top
        for k, (row, sides, height) in enumerate(zip(column, rows, heights, strict=True)):
            for piece, (a, b) in zip(self.pieces[slice(*row)], sides or (), strict=True):
                low = max(top - height, self.room.floor(b)) if k == last else top - height
                found.append(self.place(piece, Box(a, low, b, top), k == 0))
            top -= height + GAP
        return found

    def row(self, row: Row, left: float, right: float) -> list[tuple[float, float]] | None:
        """Left and right sides of the pieces of a row."""
        pieces = self.pieces[slice(*row)]
        wanted = [w for w, _ in self.wanted[slice(*row)]]
        widths = shared(wanted, [piece.least[0] for piece in pieces], right - left - GAP * (len(pieces) - 1))
        if widths is None:
            return None
        starts = [left]
        for wide in widths[:-1]:
            starts.append(starts[-1] + wide + GAP)
        return [(a, a + wide) for a, wide in zip(starts, widths, strict=True)]

    def above(self, piece: Piece, left: float, right: float, first: bool) -> float:
        """What the heading takes above the picture, and in the first row the corner of the frame."""
        top = self.room.box.top
        return top - self.place(piece, Box(left, top - 1.0, right, top), first).box.top

    def place(self, piece: Piece, box: Box, first: bool) -> Place:
        """The place of a piece in a rectangle with its heading on top; in the first row a corner may be taken.

        The heading stands beside the corner if it has room there in one line, else under it.
        """
        wide, high = self.room.corner
        beside = max(0.0, self.room.box.left + wide - box.left) if first else 0.0
        down = 0.0
        if beside and width(piece.heading, self.height) > box.width - beside:
            beside, down = 0.0, high
        short = width(piece.heading, self.height) <= box.width - beside
        lines = [piece.heading] if short else wrapped(piece.heading, box.width, self.height)
        under = down + (self.head + (len(lines) - 1) * LEADING * self.height if piece.heading else 0.0)
        if beside:
            under = max(under, high)
        at = complex((box.left + beside + box.right) / 2, box.top - down)
        return Place(piece, tuple(lines), at, box.inset(0, 0, 0, under))

    def cost(self, places: Iterable[Place]) -> float:
        """The measure of places."""
        return sum(
            measure(place.box.width / w, place.box.height / h)
            for place, (w, h) in zip(places, self.wanted, strict=True)
        )


def measure(wide: float, high: float) -> float:
    """How far the ratios of width and height to the good ones are from 1: worst where one grows and the other falls.

    >>> measure(1.0, 1.0), measure(2.0, 2.0) < measure(2.0, 0.5)
    (0.0, True)
    """
    a, b = math.log(wide), math.log(high)
    return a * a + b * b - a * b


def shared(shares: Sequence[float], needs: Sequence[float], room: float) -> list[float] | None:
    """A length divided in proportion to ``shares``, each part not less than it needs; None if there is not enough.

    >>> shared([1.0, 1.0, 2.0], [0.0, 40.0, 0.0], 100.0)
    [20.0, 40.0, 40.0]
    """
    if sum(needs) > room + EPS:
        return None
    short: set[int] = set()
    while True:
        rest = room - sum(needs[k] for k in short)
        total = sum(share for k, share in enumerate(shares) if k not in short)
        more = {k for k, share in enumerate(shares) if k not in short and share * rest < needs[k] * total}
        if not more:
            return [needs[k] if k in short else share * rest / total for k, share in enumerate(shares)]
        short |= more
