"""A document on a terminal, drawn by rich: in colour, cut to the width of the window."""

from __future__ import annotations

from typing import TextIO

from rich import box
from rich.console import Console
from rich.table import Table

from tmmcalc.core.printable import printable
from tmmcalc.report.document import Document, Fact, said_of_rows
from tmmcalc.report.layout import GAP, Cells, fitted


def draw(document: Document, stream: TextIO) -> None:
    """Print title, facts, notes and table, then the parts; what looks like markup of rich is the user's own text."""
    _draw(document, Console(file=stream, highlight=False, markup=False, emoji=False))


def _draw(document: Document, out: Console) -> None:
    out.print(printable(document.title), style="bold")
    if document.facts:
        out.print(_facts(document.facts))
    for note in document.notes:
        out.print(printable(note), style="yellow" if note.startswith("warning") else "cyan")
    columns, cut = fitted(document, out.width)
    if columns:
        out.print()
        out.print(_table(columns))
    if cut and document.more:
        out.print()
        out.print(f"{cut} more columns: {document.more}", style="dim")
    if rows := said_of_rows(document.table):
        out.print()
        out.print(rows, style="dim")
    for part in document.parts:
        out.print()
        _draw(part, out)


def _facts(facts: tuple[Fact, ...]) -> Table:
    table = Table.grid(padding=(0, GAP), pad_edge=False)
    table.add_column(no_wrap=True, style="dim")
    table.add_column()
    for fact in facts:
        table.add_row(printable(fact.label), printable(fact.text))
    return table


def _table(columns: list[Cells]) -> Table:
    """Names and units stand on two lines of the header. The gap is one cell of padding and one of the divider.

    Numbers keep their width, whatever the window: a digit must never fall off a cell.
    """
    table = Table(
        box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, collapse_padding=True, padding=(0, 1), header_style="bold"
    )
    units = any(c.unit for c in columns)
    for k, c in enumerate(columns):
        wraps = c.text and k == len(columns) - 1
        table.add_column(
            printable(f"{c.name}\n{c.unit}" if units else c.name),
            justify="left" if c.text else "right",
            min_width=None if wraps else c.width,
            no_wrap=not wraps,
        )
    for row in zip(*(c.cells for c in columns), strict=True):
        table.add_row(*map(printable, row))
    return table
