"""Where the pieces of a sheet stand: columns from left to right, in each rows from the top, in each row side by side.

Every such arrangement keeps the order of the pieces. A column is as wide, and a row as high, as its share of the area
that its pieces would like to have, but never less than they need. Of the arrangements that give every piece what it
needs that one is taken in which widths and heights are nearest to the good ones, all to one scale: the measure is the
sum of the squares of the logarithms of their ratios. Corners that a title block takes stay free.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import cached_property
from heapq import nsmallest
from typing import NamedTuple

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import LEADING, wrapped
from tmmcalc.report.sheets.piece import Piece

GAP = 6.0  # between pieces [mm]
UNDER = 4.0  # from a heading to its picture [mm]
TRIED = 150  # arrangements that are laid out in full, the most promising ones
KEPT = 16  # ways to divide one column that are joined with others
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


class Layout(NamedTuple):
    """Places of all pieces, and the measure of how far they are from what the pieces would like."""

    places: tuple[Place, ...]
    cost: float


def arranged(pieces: Sequence[Piece], room: Room, height: float) -> Layout | None:
    """The best arrangement with headings of this height [mm]; None if the pieces do not fit together."""
    task = _Task(pieces, room, height)
    found = (task.layout(columns) for columns in task.promising(TRIED))
    return min((each for each in found if each is not None), key=lambda each: each.cost, default=None)


class _Task:
    """Pieces and the room for them."""

    def __init__(self, pieces: Sequence[Piece], room: Room, height: float) -> None:
        self.pieces, self.room, self.height = pieces, room, height
        self.above = height * 1.25 + UNDER  # what a heading of one line takes

    @cached_property
    def wanted(self) -> list[tuple[float, float]]:
        """Good widths and heights of the pieces with their headings, all to the scale that fills the room."""
        good = [piece.good for piece in self.pieces]
        scale = math.sqrt(self.room.area / sum((w + GAP) * (h + GAP + self.above) for w, h in good))
        return [(w * scale, h * scale) for w, h in good]

    @cached_property
    def areas(self) -> list[float]:
        """What of the room each piece would like to have."""
        return [(w + GAP) * (h + GAP + self.above) for w, h in self.wanted]

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
        high = sum(self.areas[first:last]) / wide - GAP - self.above
        across = wide - GAP * (last - first)
        share = across / sum(w for w, _ in self.wanted[first:last])
        if high <= 0 or across <= 0:
            return math.inf
        return sum(math.log(share) ** 2 + math.log(high / h) ** 2 for _, h in self.wanted[first:last])

    # laying one out

    def layout(self, columns: tuple[Column, ...]) -> Layout | None:
        """Places in an arrangement; None where a piece would have less than it needs."""
        return min(
            (found for snapped in range(len(columns)) if (found := self.laid(columns, snapped)) is not None),
            key=lambda each: each.cost,
            default=None,
        )

    def laid(self, columns: tuple[Column, ...], snapped: int) -> Layout | None:
        """Places where the columns from ``snapped`` on are as wide together as the title block; 0: as they come."""
        left, right = self.room.box.left, self.room.box.right
        needs = [max(self.across(row) for row in column) for column in columns]
        shares = [sum(self.areas[column[0][0] : column[-1][1]]) for column in columns]
        edge = right - self.room.block[0]
        if snapped and edge in (left, right):
            return None
        groups = [(0, len(columns), left, right)]
        if snapped:
            groups = [(0, snapped, left, edge), (snapped, len(columns), edge + GAP, right)]
        places: list[Place] = []
        for first, last, begin, end in groups:
            widths = shared(shares[first:last], needs[first:last], end - begin - GAP * (last - first - 1))
            if widths is None:
                return None
            at = begin
            for column, width in zip(columns[first:last], widths, strict=True):
                found = self.column(column, at, at + width)
                if found is None:
                    return None
                places += found
                at += width + GAP
        return Layout(tuple(places), self.cost(places))

    def across(self, row: Row) -> float:
        """The least width of a row."""
        return sum(piece.least[0] for piece in self.pieces[slice(*row)]) + GAP * (row[1] - row[0] - 1)

    def column(self, column: Column, left: float, right: float) -> list[Place] | None:
        """Places in a column."""
        box = self.room.box
        rows = [self.row(row, left, right) for row in column]
        needs, shares = [], []
        for k, (row, sides) in enumerate(zip(column, rows, strict=True)):
            if sides is None:
                return None
            lost = [self.lost(a, b, k == 0, k == len(rows) - 1) for a, b in sides]
            pieces = self.pieces[slice(*row)]
            heads = [self.head(piece, b - a) for piece, (a, b) in zip(pieces, sides, strict=True)]
            needs.append(max(p.least[1] + h + w for p, h, w in zip(pieces, heads, lost, strict=True)))
            shares.append(sum(self.areas[slice(*row)]) / (right - left) + max(lost, default=0.0) / 2)
        heights = shared(shares, needs, box.height - GAP * (len(column) - 1))
        if heights is None:
            return None
        found, top = [], box.top
        for k, (row, sides, height) in enumerate(zip(column, rows, heights, strict=True)):
            bottom = top - height
            for piece, (a, b) in zip(self.pieces[slice(*row)], sides or (), strict=True):
                low = max(bottom, self.room.floor(b)) if k == len(rows) - 1 else bottom
                found.append(self.place(piece, Box(a, low, b, top)))
            top = bottom - GAP
        return found

    def row(self, row: Row, left: float, right: float) -> list[tuple[float, float]] | None:
        """Left and right sides of the pieces of a row."""
        pieces = self.pieces[slice(*row)]
        wanted = [w for w, _ in self.wanted[slice(*row)]]
        widths = shared(wanted, [piece.least[0] for piece in pieces], right - left - GAP * (len(pieces) - 1))
        if widths is None:
            return None
        starts = [left]
        for width in widths[:-1]:
            starts.append(starts[-1] + width + GAP)
        return [(a, a + width) for a, width in zip(starts, widths, strict=True)]

    def lost(self, left: float, right: float, top: bool, bottom: bool) -> float:
        """Height that corners take of a piece in the first or the last row of its column."""
        under = self.room.floor(right) - self.room.box.bottom if bottom else 0.0
        return under + (self.beside(left) if top else 0.0)

    def beside(self, left: float) -> float:
        """What the corner above takes of a piece, whose heading stands beside it."""
        wide, high = self.room.corner
        return max(0.0, high + UNDER - self.above) if left < self.room.box.left + wide - EPS else 0.0

    def lines(self, piece: Piece, wide: float) -> list[str]:
        """A heading in lines that are no wider."""
        return wrapped(piece.heading, wide, self.height) if piece.heading else []

    def head(self, piece: Piece, wide: float) -> float:
        """What a heading takes above its picture."""
        lines = len(self.lines(piece, wide))
        return self.above + (lines - 1) * LEADING * self.height if lines else 0.0

    def place(self, piece: Piece, box: Box) -> Place:
        """The place of a piece in a rectangle: its heading on top."""
        taken = self.room.corner[0] if box.top > self.room.box.top - EPS and self.beside(box.left) else 0.0
        beside = max(0.0, self.room.box.left + taken - box.left) if taken else 0.0
        lines = self.lines(piece, box.width - beside)
        under = self.above + (len(lines) - 1) * LEADING * self.height if lines else 0.0
        if beside:
            under = max(under, self.room.corner[1] + UNDER)
        head = complex((box.left + beside + box.right) / 2, box.top)
        return Place(piece, tuple(lines), head, box.inset(0, 0, 0, under))

    def cost(self, places: Iterable[Place]) -> float:
        """The measure of places."""
        return sum(
            math.log(place.box.width / w) ** 2 + math.log(place.box.height / h) ** 2
            for place, (w, h) in zip(places, self.wanted, strict=True)
        )


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
