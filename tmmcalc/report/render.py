"""Documents in four formats: table, csv, json, toml.

A table on a terminal is drawn by rich; into a pipe or a file it goes as plain text of 80 columns, which spares
the import of rich, a fifth of the time of a short command. Hidden characters of names are written out in all of them.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from typing import Any, TextIO

from tmmcalc.core.notes import finding
from tmmcalc.core.printable import escaped, printable
from tmmcalc.report.document import Document
from tmmcalc.report.layout import yes_or_no


def render(document: Document, form: str, stream: TextIO | None = None) -> None:
    """Write the document as table, csv, json or toml to ``stream`` (standard output by default)."""
    stream = stream or sys.stdout
    if form != "table":
        stream.write({"csv": _csv, "json": _json, "toml": _toml}[form](document))
    elif stream.isatty():
        from tmmcalc.report.terminal import draw

        draw(document, stream)
    else:
        from tmmcalc.report.plaintext import lines

        stream.writelines(f"{printable(line)}\n" for line in lines(document))


def _payload(document: Document, findings: bool = True) -> dict[str, Any]:
    """Facts, notes and columns as plain values, parts under their titles; keys without a value are left out.

    With ``findings`` notes are told as data too.
    """
    values = {k: v for fact in document.facts for k, v in fact.values.items() if v is not None}
    payload: dict[str, Any] = {"title": document.title, **values}
    if document.notes:
        payload["notes"] = [str(note) for note in document.notes]
        if findings:
            payload["findings"] = [finding(note) for note in document.notes]
    if document.table is not None:
        payload["columns"] = {h: list(c) for h, c in zip(document.table.headers, document.table.columns, strict=True)}
    for part in document.parts:
        payload[part.title] = {k: v for k, v in _payload(part, findings).items() if k != "title"}
    return payload


def _json(document: Document) -> str:
    import json

    return escaped(json.dumps(_payload(document), indent=2, ensure_ascii=False, allow_nan=False)) + "\n"


def _toml(document: Document) -> str:
    import tomli_w

    return escaped(tomli_w.dumps(_without_null(_payload(document))))


def _without_null(value: Any) -> Any:
    """TOML has no null: keys without a value are left out at every depth, in a list an empty cell stands as in CSV."""
    if isinstance(value, dict):
        return {k: _without_null(v) for k, v in value.items() if v is not None}
    if isinstance(value, list | tuple):
        return ["" if each is None else _without_null(each) for each in value]
    return value


def _csv(document: Document) -> str:
    """The table alone; a document without one gives its values as two columns: name, value."""
    import csv
    import io

    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    if document.table is None:
        writer.writerow(["name", "value"])
        writer.writerows((k, v) for k, v in _flat(_payload(document, findings=False)) if k != "title")
    else:
        writer.writerow(document.table.headers)
        rows = zip(*document.table.columns, strict=True)
        writer.writerows([yes_or_no(cell) for cell in row] for row in rows)
    return printable(buffer.getvalue())


def _flat(payload: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Names joined by dots with their values; lists end in .0, .1, ..."""
    for name, value in payload.items():
        if isinstance(value, list):
            value = {str(k): item for k, item in enumerate(value)}
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", str(value).lower() if isinstance(value, bool) else value
