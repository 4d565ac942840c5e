"""The document of a sweep: how many points, what failed and why, the range of every quantity."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.batch.sheet import Sheet

SHOWN = 5  # reasons that are told


def sweep_document(sheet: Sheet, title: str) -> Document:
    """Points, failures by their reason, least and largest of every quantity with the row where it stands."""
    return Document(title, (_points(sheet), *_failures(sheet), *_ranges(sheet)))


def _points(sheet: Sheet) -> Fact:
    count, failed = len(sheet.status), sheet.failed
    text = f"{count}, {failed} of them failed" if failed else f"{count}, all solved"
    return Fact("points", text, {"points": count, "failed": failed})


def _failures(sheet: Sheet) -> Iterator[Fact]:
    """Failures of one kind are those whose reasons differ in their numbers alone; the first of a kind is told."""
    kinds: dict[tuple[str, str], list[int]] = {}
    for row, (status, reason) in enumerate(zip(sheet.status, sheet.reasons, strict=True), 1):
        if reason:
            kinds.setdefault((status, re.sub(r"[\d.e+-]+", "#", reason)), []).append(row)
    often = sorted(kinds.items(), key=lambda item: -len(item[1]))
    for at, ((status, _), rows) in enumerate(often[:SHOWN], 1):
        reason = sheet.reasons[rows[0] - 1]
        values = {"status": status, "reason": reason, "points": len(rows), "row": rows[0]}
        yield Fact(f"{status}: {len(rows)}", f"row {rows[0]}: {reason}", {f"failure_{at}": values})
    if len(often) > SHOWN:
        yield Fact("other failures", f"{len(often) - SHOWN} more kinds: see the column reason", {})


def _ranges(sheet: Sheet) -> Iterator[Fact]:
    """A fact for every quantity that varies, one for all the others."""
    same: dict[str, float] = {}
    values: dict[str, object] = {}
    for name, column in zip(sheet.names, sheet.values.T, strict=True):
        if np.isnan(column).all():
            continue
        low, high = int(np.nanargmin(column)), int(np.nanargmax(column))
        least, largest = float(column[low]), float(column[high])
        told = {"least": least, "least_row": low + 1, "largest": largest, "largest_row": high + 1}
        if least == largest:
            same[name], values[name] = least, told
        else:
            text = f"{number(least)} (row {low + 1}) to {number(largest)} (row {high + 1})"
            yield Fact(name, text, {name: told})
    if same:
        yield Fact("the same in all", ", ".join(f"{name} = {number(value)}" for name, value in same.items()), values)
