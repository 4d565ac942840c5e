"""Documents as HTML for notebooks: a table of facts, the notes, the table. Every text of the user's stays a text."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from tmmcalc.core.printable import printable
from tmmcalc.report.document import Document
from tmmcalc.report.layout import Cells, fitted

WIDTH = 100  # characters of the columns that are shown
ROWS = 25  # rows that are shown


def html(document: Document) -> str:
    """The document as a piece of HTML; the parts of one with several can be opened."""
    return "\n".join(_lines(document))


def _lines(document: Document) -> Iterator[str]:
    yield "<div>"
    yield f"<strong>{_text(document.title)}</strong>"
    yield from _content(document)
    for part in document.parts:
        yield f"<details><summary>{_text(part.title)}</summary>"
        yield from _content(part)
        yield "</details>"
    yield "</div>"


def _content(document: Document) -> Iterator[str]:
    if document.facts:
        yield "<table>"
        for fact in document.facts:
            told = "<br>".join(map(_text, fact.text.split("\n")))
            left = 'style="text-align:left"'
            yield f"<tr><td {left}>{_text(fact.label)}</td><td {left}>{told}</td></tr>"
        yield "</table>"
    for note in document.notes:
        yield f"<p>{_text(note)}</p>"
    columns, cut = fitted(document, WIDTH)
    if columns:
        yield from _table(columns)
        rows = len(columns[0].cells) - ROWS
        left_out = [f"{count} more {what}" for count, what in ((rows, "rows"), (cut, "columns")) if count > 0]
        if left_out:
            yield f"<p>{' and '.join(left_out)}</p>"


def _table(columns: list[Cells]) -> Iterator[str]:
    yield "<table>"
    heads = "".join(f"<th>{_text(cells.name)}<br>{_text(cells.unit)}</th>" for cells in columns)
    yield f"<thead><tr>{heads}</tr></thead>"
    for row in zip(*(cells.cells[:ROWS] for cells in columns), strict=True):
        yield f"<tr>{''.join(f'<td>{_text(cell)}</td>' for cell in row)}</tr>"
    yield "</table>"


def _text(text: str) -> str:
    return escape(printable(text))
