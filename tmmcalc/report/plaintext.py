"""A document as plain text of 80 columns, for pipes and files."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest
from textwrap import wrap

from tmmcalc.report.document import Document, Fact, said_of_rows
from tmmcalc.report.layout import GAP, Cells, fitted

WIDTH = 80
NARROWEST = 20  # characters left to a text, however long the label or the columns before it


def lines(document: Document) -> Iterator[str]:
    """The lines of the document: its blocks with an empty line between them."""
    yield document.title
    for block in _blocks(document):
        if block:
            yield ""
            yield from block
    for part in document.parts:
        yield ""
        yield from lines(part)


def _blocks(document: Document) -> Iterator[list[str]]:
    """Facts, notes, the table, and what it does not show."""
    label = max((len(fact.label) for fact in document.facts), default=0)
    yield [line for fact in document.facts for line in _fact(fact, label)]
    yield [line for note in document.notes for line in _wrapped(note, WIDTH, "  ")]
    columns, cut = fitted(document, WIDTH)
    yield list(_table(columns))
    yield _wrapped(f"{cut} more columns: {document.more}", WIDTH) if cut and document.more else []
    rows = said_of_rows(document.table)
    yield _wrapped(rows, WIDTH) if rows else []


def _fact(fact: Fact, label: int) -> Iterator[str]:
    room = max(WIDTH - label - GAP, NARROWEST)
    pieces = [piece for line in fact.text.split("\n") for piece in _wrapped(line, room)]
    for k, piece in enumerate(pieces):
        yield f"{fact.label if k == 0 else '':<{label}}{' ' * GAP}{piece}"


def _wrapped(text: str, width: int, indent: str = "") -> list[str]:
    if len(text) <= width and text.isprintable() and not text.endswith(" "):
        return [text]  # as most are, and as `wrap` gives it back from words
    return wrap(text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False) or [""]


def _table(columns: list[Cells]) -> Iterator[str]:
    """Names, units, a rule, the rows; long texts are wrapped."""
    if not columns:
        return
    widths = _widths(columns)
    heads = [[c.name for c in columns], [c.unit for c in columns], ["-" * width for width in widths]]
    if not any(heads[1]):
        del heads[1]
    for row in [*heads, *zip(*(c.cells for c in columns), strict=True)]:
        wrapped = [
            _wrapped(cell, width) if c.text else [cell] for cell, c, width in zip(row, columns, widths, strict=True)
        ]
        for cells in zip_longest(*wrapped, fillvalue=""):
            parts = (_cell(cell, c.text, width) for cell, c, width in zip(cells, columns, widths, strict=True))
            yield (" " * GAP).join(parts).rstrip()


def _widths(columns: list[Cells]) -> list[int]:
    """Widths that fit the page: a last column of texts gives way first, then the widest text before it.

    None is narrower than its longest word, which is never broken.
    """
    widths = [c.width for c in columns]
    if not columns[-1].text:
        return widths
    last, *others = (k for k in reversed(range(len(columns))) if columns[k].text)
    for k in (last, *sorted(others, key=lambda k: -widths[k])):
        over = sum(widths) + GAP * (len(widths) - 1) - WIDTH
        widths[k] = min(widths[k], max(widths[k] - over, NARROWEST, _longest(columns[k])))
    return widths


def _longest(column: Cells) -> int:
    """Characters of the longest word of a column."""
    return max(len(word) for text in (column.name, column.unit, *column.cells) for word in text.split() or [""])


def _cell(text: str, left: bool, width: int) -> str:
    return f"{text:<{width}}" if left else f"{text:>{width}}"
