"""A document as plain text of 80 columns, for pipes and files."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from tmmcalc.report.document import Document, Fact
from tmmcalc.report.layout import GAP, Cells, fitted

WIDTH = 80


def lines(document: Document) -> Iterator[str]:
    """The lines of the document."""
    yield document.title
    yield ""
    label = max((len(fact.label) for fact in document.facts), default=0)
    for fact in document.facts:
        yield from _fact(fact, label)
    if document.facts:
        yield ""
    for note in document.notes:
        yield from wrap(note, WIDTH, subsequent_indent="  ")
    if document.notes:
        yield ""
    columns, cut = fitted(document, WIDTH)
    yield from _table(columns)
    if cut and document.more:
        yield ""
        yield from wrap(f"{cut} more columns: {document.more}", WIDTH)


def _fact(fact: Fact, label: int) -> Iterator[str]:
    room = max(WIDTH - label - GAP, 20)
    pieces = [piece for line in fact.text.split("\n") for piece in (wrap(line, room) or [""])]
    for k, piece in enumerate(pieces):
        yield f"{fact.label if k == 0 else '':<{label}}{' ' * GAP}{piece}"


def _table(columns: list[Cells]) -> Iterator[str]:
    if not columns:
        return
    rows = [[c.name for c in columns], [c.unit for c in columns], ["-" * c.width for c in columns]]
    rows += [list(row) for row in zip(*(c.cells for c in columns), strict=True)]
    if not any(rows[1]):
        del rows[1]
    for row in rows:
        parts = (f"{t:<{c.width}}" if c.text else f"{t:>{c.width}}" for t, c in zip(row, columns, strict=True))
        yield (" " * GAP).join(parts).rstrip()
