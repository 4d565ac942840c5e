"""A document as plain text of 80 columns, for pipes and files."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from tmmcalc.report.document import Document, Fact
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


def _fact(fact: Fact, label: int) -> Iterator[str]:
    room = max(WIDTH - label - GAP, NARROWEST)
    pieces = [piece for line in fact.text.split("\n") for piece in _wrapped(line, room)]
    for k, piece in enumerate(pieces):
        yield f"{fact.label if k == 0 else '':<{label}}{' ' * GAP}{piece}"


def _wrapped(text: str, width: int, indent: str = "") -> list[str]:
    return wrap(text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False) or [""]


def _table(columns: list[Cells]) -> Iterator[str]:
    """Names, units, a rule, the rows; a last column of long texts is wrapped."""
    if not columns:
        return
    before = sum(c.width + GAP for c in columns[:-1])
    room = max(WIDTH - before, NARROWEST) if columns[-1].text else columns[-1].width
    widths = [*(c.width for c in columns[:-1]), min(columns[-1].width, room)]
    heads = [[c.name for c in columns], [c.unit for c in columns], ["-" * width for width in widths]]
    if not any(heads[1]):
        del heads[1]
    for *row, last in [*heads, *zip(*(c.cells for c in columns), strict=True)]:
        for k, piece in enumerate(_wrapped(last, room) if columns[-1].text else [last]):
            cells = [*(row if k == 0 else [""] * len(row)), piece]
            parts = (_cell(cell, c.text, width) for cell, c, width in zip(cells, columns, widths, strict=True))
            yield (" " * GAP).join(parts).rstrip()


def _cell(text: str, left: bool, width: int) -> str:
    return f"{text:<{width}}" if left else f"{text:>{width}}"
