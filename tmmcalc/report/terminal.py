"""A document on a terminal, drawn by rich: in colour, cut to the width of the window."""

from __future__ import annotations

from typing import TextIO

from rich import box
from rich.console import Console
from rich.table import Table

from tmmcalc.report.document import Document, Fact
from tmmcalc.report.layout import Cells, fitted


def draw(document: Document, stream: TextIO) -> None:
    """Print title, facts, notes and table."""
    out = Console(file=stream, highlight=False)
    out.print(document.title, style="bold", markup=False)
    if document.facts:
        out.print(_facts(document.facts))
    for note in document.notes:
        out.print(note, style="yellow" if note.startswith("warning") else "cyan", markup=False)
    columns, cut = fitted(document, out.width)
    if columns:
        out.print(_table(columns))
    if cut and document.more:
        out.print(f"{cut} more columns: {document.more}", style="dim", markup=False)


def _facts(facts: tuple[Fact, ...]) -> Table:
    table = Table.grid(padding=(0, 2))
    table.add_column(no_wrap=True, style="dim")
    table.add_column(overflow="fold")
    for fact in facts:
        table.add_row(fact.label, fact.text)
    return table


def _table(columns: list[Cells]) -> Table:
    """Names and units stand on two lines of the header."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1), header_style="bold")
    for c in columns:
        title = f"{c.name}\n{c.unit}" if c.unit else c.name
        table.add_column(title, justify="left" if c.text else "right", no_wrap=not c.text, overflow="fold")
    for row in zip(*(c.cells for c in columns), strict=True):
        table.add_row(*row)
    return table
