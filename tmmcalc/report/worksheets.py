"""Sheets of a workbook as plain values: of a document its facts and its tables, and which columns are drawn.

What is told of a stage is a row: name, symbol, value, unit, meaning. A table stands from the first cell, so that other
programs find it there; what is said of it, and its charts, stand beside it. `tmmcalc.report.workbook` writes them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import count
from typing import Any, NamedTuple

from tmmcalc.core.facts import named
from tmmcalc.core.notes import Note, graded
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.meanings import described
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.layout import fitted
from tmmcalc.report.numbers import as_number, counted_back

TOLD = ("name", "symbol", "value", "unit", "meaning")
OVER = ("phi", "t", "x")  # columns that others are drawn over
FEW = 8  # values of a list that have a row each
LEAST = 5  # rows of a chart
STRAIGHT = 1e-9  # of the range of a column: what is so near to a straight line is not drawn
PEOPLE = 80  # characters of a line: the columns that fit are those that a reader looks at first
NAME = 31  # characters of the name of a sheet
_BARRED = re.compile(r"[\[\]:*?/\\]|^'|'$")


@record
class Worksheet:
    """A sheet: its table, what is said beside it, and the names of the columns that a reader looks at first."""

    name: str
    headers: Sequence[str]
    columns: Sequence[Sequence[Any]]  # of equal length: numbers, texts, truth values; None: nothing
    beside: Sequence[tuple[str, Any]] = ()
    main: Sequence[str] = ()

    @property
    def rows(self) -> int:
        """Rows under the header."""
        return len(self.columns[0]) if self.columns else 0

    @property
    def warns(self) -> bool:
        """Whether a warning stands beside the table."""
        return any(label == "warning" for label, _ in self.beside)


class Curves(NamedTuple):
    """What one chart shows: columns of one unit, over another column; all by their numbers."""

    over: int
    drawn: list[int]


def sheets_of(document: Document, stage: str = "", main: Sequence[str] | None = None) -> list[Worksheet]:
    """The summary of a document, and a sheet for each of its tables.

    ``stage`` is the one that it is of, ``main`` are the names of the columns that a reader looks at first (None: those
    that the document shows people).
    """
    parts = [(stage, document), *((part.title, part) for part in document.parts)]
    rows = [(name, *row) for name, part in parts for row in told_of(part, name)]
    first, headers = (0, ("part", *TOLD)) if document.parts else (1, TOLD)
    summary = Worksheet("summary", headers, [*zip(*(row[first:] for row in rows), strict=True)] or [()] * len(headers))
    tables = [_table(name, part, main) for name, part in parts if part.table is not None]
    return [summary, *tables] if rows or not tables else tables


def _table(name: str, document: Document, main: Sequence[str] | None) -> Worksheet:
    assert document.table is not None
    shown = first_columns(document) if main is None else main
    return table_sheet(name or "table", document.table, beside_of(document), shown)


def table_sheet(name: str, view: View, beside: Sequence[tuple[str, Any]] = (), main: Sequence[str] = ()) -> Worksheet:
    """The sheet of a table; of the labels of its rows those that are numbers are numbers."""
    columns = [counted_back(column) for column in view.columns]
    if columns and view.headers[0] == "i":
        columns[0] = [as_number(str(label)) for label in columns[0]]
    return Worksheet(name, view.headers, columns, beside, main)


def first_columns(document: Document) -> list[str]:
    """Names of the columns that people are shown first."""
    return [cells.name for cells in fitted(document, PEOPLE)[0]]


def told_of(document: Document, stage: str = "") -> Iterator[tuple[str, str, Any, str, str]]:
    """Every value that a document tells: name, symbol, value, unit, meaning; then its notes with their numbers.

    The meaning is that which the ``stage`` declares, else what the document calls it.
    """
    known = described(stage, column=False) if stage in STAGES else None
    for fact in document.facts:
        for name, value, unit in values_of(fact):
            meaning, symbol = known(name.rpartition(".")[2], unit) if known else ("", "")
            yield name, symbol, value, unit, meaning or fact.label
    for note in document.notes:
        grade, text = graded(note)
        yield grade, "", text, "", ""
        if isinstance(note, Note):
            held = {"value": note.value, "limit": note.limit}
            yield from ((f"{grade} {word}", note.name, n, note.unit, text) for word, n in held.items() if n is not None)


def notes_of(document: Document) -> Iterator[tuple[str, str]]:
    """The notes, each with its grade."""
    yield from map(graded, document.notes)


def beside_of(document: Document) -> list[tuple[str, Any]]:
    """What is said beside the table of a stage: its notes, and the estimates of its errors."""
    errors = [fact for fact in document.facts if isinstance(fact.values.get("error"), Mapping)]
    estimates = ((fact.label, name.partition(".")[2], value) for fact in errors for name, value, _ in values_of(fact))
    return [*notes_of(document), *((f"{label}: {name}", value) for label, name, value in estimates)]


def values_of(fact: Fact) -> Iterator[tuple[str, Any, str]]:
    """The values of a fact one by one, with name and unit; of a short list ``name.0``, ``name.1``, a long one as JSON.

    >>> list(values_of(Fact("strokes", "", {"stroke[m]": [0.1, 0.2], "K": 1.5})))
    [('stroke.0', 0.1, 'm'), ('stroke.1', 0.2, 'm'), ('K', 1.5, '')]
    """
    yield from _values(fact.values, "")


def _values(values: Mapping[str, Any], path: str, outer: str = "") -> Iterator[tuple[str, Any, str]]:
    """``outer`` is the unit of the record that these values are of."""
    for key, value in values.items():
        name, unit = named(key)
        if isinstance(value, Mapping):
            yield from _values(value, f"{path}{key}.", unit or outer)
        elif isinstance(value, list | tuple) and _short(value):
            listed = {str(k): each for k, each in enumerate(value)}
            yield from _values(listed, f"{path}{name}.", unit or outer)
        elif isinstance(value, list | tuple):
            yield f"{path}{name}", json.dumps(value, ensure_ascii=False), unit or outer
        elif value is not None:
            yield f"{path}{name}", value, unit or (outer if isinstance(value, float) else "")


def _short(values: Sequence[Any]) -> bool:
    return len(values) <= FEW and not any(isinstance(value, list | tuple) for value in values)


def curves_of(sheet: Worksheet) -> list[Curves]:
    """The charts of a sheet, one for each unit of its main columns; none where rows are no places of a motion."""
    names = [named(header)[0] for header in sheet.headers]
    over = next((k for k, name in enumerate(names) if name in OVER and _one_way(sheet.columns[k])), None)
    if over is None or sheet.rows < LEAST:
        return []
    x = sheet.columns[over]
    found: dict[str, list[int]] = {}
    for k, name in enumerate(names):
        numeric = k != over and name != "i" and name in sheet.main and _numbers(sheet.columns[k])
        if numeric and not _straight(x, sheet.columns[k]):
            found.setdefault(named(sheet.headers[k])[1], []).append(k)
    return [Curves(over, drawn) for drawn in found.values()]


def _numbers(column: Sequence[Any]) -> bool:
    return all(isinstance(value, int | float) and not isinstance(value, bool) for value in column)


def _one_way(column: Sequence[Any]) -> bool:
    if not _numbers(column) or not column or column[0] == column[-1]:
        return False
    low, high = (column, column[1:]) if column[0] < column[-1] else (column[1:], column)
    return all(a <= b for a, b in zip(low, high, strict=False))


def _straight(x: Sequence[float], y: Sequence[float]) -> bool:
    """Whether a column is a straight line over another, a constant too: nothing that a chart would tell."""
    slope = (y[-1] - y[0]) / (x[-1] - x[0])
    off = max(abs(b - y[0] - slope * (a - x[0])) for a, b in zip(x, y, strict=True))
    return off <= STRAIGHT * max(map(abs, y))


def sheet_names(names: Iterable[str]) -> list[str]:
    r"""Names as a workbook can have them: of 31 characters at most, without ``[]:*?/\``, none twice in any case.

    >>> sheet_names(["pair", "a/b", "Pair", "x" * 40])
    ['pair', 'a_b', 'Pair 2', 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx']
    """
    found: dict[str, str] = {}
    for name in names:
        plain = _BARRED.sub("_", name)[:NAME] or "sheet"
        ends = ("" if k == 1 else f" {k}" for k in count(1))
        tried = (f"{plain[: NAME - len(end)]}{end}" for end in ends)
        own = next(each for each in tried if each.lower() not in found and each.lower() != "history")
        found[own.lower()] = own
    return list(found.values())
