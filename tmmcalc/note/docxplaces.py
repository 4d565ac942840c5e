"""The order of blocks in a document of Word in which no page is left half empty.

Word sets a picture or a table where it is told of, and leaves blank what it does not fit in. Its pages are known to
Word alone, but heights can be told well enough to let the text that follows stand before such a picture.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.note.columns import widths_of
from tmmcalc.note.docxtables import PADDING, WHOLE, size_of
from tmmcalc.note.tree import (
    ACROSS,
    POINT,
    Contents,
    Cover,
    Equation,
    Grid,
    Image,
    Points,
    Source,
    Text,
    Title,
    Written,
    leads,
    part_width,
)
from tmmcalc.report.formula.breaking import broken, width
from tmmcalc.report.formula.layout import Big, Box, Fraction, Row, inner

HIGH = 257.0  # of the text of a page [mm]
TIMES = 0.95  # widths of texts in Times, of those in letters of the note
SIZE, LINE = 14.0, 8.51  # of the text: of its letters [pt], height of its lines [mm]
INDENT = 12.5  # of the first line of a paragraph [mm]
ROW = 0.4  # height of a row of a table to the size of its letters [mm/pt]
FILLED = 0.92  # of the width of a cell, where its words are broken into lines
EDGE = 0.1  # and of a line between two rows [mm]
CAPTION, UNDER, BELOW = 7.3, 7.0, 2.8  # height of a caption, and of the blank under a picture, under a table [mm]
HEADING = 6.35  # blank over and under a heading [mm]
FORMULA, HIGHER = 5.9, 5.0  # height of a row of a formula, and how much higher one with a fraction is [mm]
WIDE = 34.0  # of a formula before it is broken [em]
SPARE = 20.0  # left free before a turned page, for what is told of heights is not exact [mm]
LEAST = 2  # lines of a paragraph that stand alone on a page


def ordered(blocks: Sequence[Written]) -> Iterator[Written]:
    """The blocks; a picture or a table that does not fit on the page stands behind the text that fills it.

    Pictures keep their order, and so do tables; none leaves its chapter.
    """
    page, waiting = _Page(), list[Written]()
    for chain in _chains(blocks):
        first = chain[0]
        if isinstance(first, Title) and first.level == 1:
            yield from page.take(waiting, every=True)
            if not first.number[:1].isdigit():
                page.turn()
        behind = isinstance(first, Image | Grid) and any(type(each) is type(first) for each in waiting)
        if len(chain) == 1 and (behind or (page.floats(first) and page.left < page.height(first))):
            waiting.append(first)
            continue
        if waiting:
            turns = any(map(page.turned, waiting))  # the page: a few lines on the next one would stand there alone
            if page.left < (sum(map(page.height, chain)) + SPARE if turns else page.least(chain)):
                yield from page.take(waiting)
        kinds = {type(each) for each in chain} & {type(each) for each in waiting}
        if kinds & {Image, Grid}:
            yield from page.take(waiting, every=True)
        before = page.count
        page.put(chain)
        yield from chain
        if page.count > before:
            yield from page.take(waiting)
    yield from page.take(waiting, every=True)


class _Page:
    """How far the page is filled."""

    def __init__(self) -> None:
        self.left, self.count = HIGH, 1
        self._heights: dict[int, float] = {}

    def height(self, block: Written) -> float:
        """About how high a block is [mm]; no page has room for a table that is turned."""
        found = self._heights.get(id(block))
        if found is None:
            found = self._heights[id(block)] = _height(block)
        return found

    def turned(self, block: Written) -> bool:
        """Whether a block stands turned on a page of its own."""
        return isinstance(block, Grid) and self.height(block) == math.inf

    def floats(self, block: Written) -> bool:
        """Whether a block may stand behind the text that follows it."""
        return isinstance(block, Image) or (
            isinstance(block, Grid) and (len(block.rows) <= WHOLE or self.turned(block))
        )

    def least(self, chain: Sequence[Written]) -> float:
        """The room without which the first of blocks that stay together begins another page [mm]."""
        *others, last = chain
        high = self.height(last)
        breaks = isinstance(last, Text | Points) or (isinstance(last, Grid) and len(last.rows) > WHOLE)
        if breaks and high > (LEAST + LEAST - 0.5) * LINE:
            high = LEAST * LINE  # on either page
        return sum(map(self.height, others)) + high

    def turn(self) -> None:
        """Begin another page, if this one has anything."""
        if self.left < HIGH:
            self.left, self.count = HIGH, self.count + 1

    def put(self, chain: Sequence[Written]) -> None:
        """Set blocks that stay together as far as one page has room for them."""
        if self.left < self.least(chain):
            self.turn()
        for block in chain:
            if isinstance(block, Cover | Contents) or self.turned(block):
                self.turn()
                self.left = 0.0
                continue
            high = self.height(block)
            while high > self.left:
                high -= self.left
                self.left = 0.0
                self.turn()
            self.left -= high

    def take(self, waiting: list[Written], *, every: bool = False) -> Iterator[Written]:
        """Set what waits: the first of it, on the next page if it has to be, and what fits behind it, or every one."""
        first = True
        while waiting and (first or every or self.least(waiting[:1]) <= self.left):
            block = waiting.pop(0)
            self.put([block])
            yield block
            first = False


def _chains(blocks: Sequence[Written]) -> Iterator[list[Written]]:
    """Blocks that stay with what follows them: headings, words that lead to something, a formula with its letters."""
    chain: list[Written] = []
    for block, following in zip(blocks, [*blocks[1:], None], strict=True):
        chain.append(block)
        if not holds(block, following):
            yield chain
            chain = []


def holds(block: Written, following: Written | None) -> bool:
    """Whether a block stays on a page with the one behind it."""
    match block, following:
        case (Title(), _) if following is not None:
            return True
        case (Text(), _):
            return leads(block) and following is not None
        case (Equation(_, number), Text(_, explains)):
            return bool(number) and explains
        case (Equation(_, number), Equation(_, other)):
            return bool(number) and not other
    return False


def _height(block: Written) -> float:
    """About how high a block is [mm]."""
    match block:
        case Title(_, _, level):
            return HEADING + LINE * (1.15 if level == 1 else 1.0)
        case Text(parts, explains):
            wide = (0.0 if explains else INDENT) + _wide(block, SIZE)
            return LINE * max(1, math.ceil(wide / ACROSS)) + HIGHER * any(_high(each) for each in parts)
        case Points(items):
            return sum(LINE * math.ceil(_wide(item, SIZE) / (ACROSS - INDENT)) for item in items)
        case Equation(parts):
            rows = broken(parts, WIDE) if sum(map(width, parts)) > WIDE else [Row(tuple(parts))]
            return sum(FORMULA + HIGHER * _high(row) for row in rows)
        case Grid():
            return _table(block)
        case Image(_, drawing):
            return drawing.height + CAPTION + UNDER
        case Source(text):
            return 3.2 * text.count("\n")
    return 0.0


def _table(grid: Grid) -> float:
    """The height of a table with its caption [mm]; of one that is turned more than a page has."""
    size = size_of(grid, ACROSS)
    if size is None:
        return math.inf
    widths = widths_of(grid, size * POINT, PADDING, ACROSS)
    high = CAPTION * math.ceil(_wide(grid.caption.whole, 12.0) / ACROSS) + BELOW
    for row in (grid.head, *grid.rows):
        cells = zip(row, widths, strict=True)
        lines = max(math.ceil(_wide(cell, size) / max(FILLED * (wide - PADDING), 1.0) - 0.05) for cell, wide in cells)
        high += ROW * size * max(1, lines) + EDGE
    return high


def _wide(text: Text, size: float) -> float:
    """About how wide a text is on one line [mm]."""
    return TIMES * POINT * size * sum(map(part_width, text.parts))


def _high(box: object) -> bool:
    """Whether a part of a text is higher than a line."""
    return isinstance(box, Fraction | Big) or (isinstance(box, Box) and any(map(_high, inner(box))))
