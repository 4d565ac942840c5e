"""The tables over the turn of the cam: columns chosen by name; people get some forty rows of the many."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase

import numpy as np

from tmmcalc.cams.program import Positions
from tmmcalc.core.columns import Column, picked
from tmmcalc.core.quantity import quantity_of
from tmmcalc.report.document import Document, View
from tmmcalc.report.positions import more
from tmmcalc.report.sizes import drawn, plain

PHI = quantity_of(Positions, "degrees")
ROWS = 40  # of the table for people
STEPS = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0)  # [deg] of its rows
NEAR = 1e-6
LEFT_OUT = "note: the table leaves rows out; --positions names them, --format csv prints all"


def with_rows(
    told: Document,
    columns: Mapping[str, np.ndarray],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    *,
    ends: Sequence[float],
    everything: bool,
    example: str,
    where: str,
) -> Document:
    """The document with its table of columns by headers; ``patterns`` choose some by name, ``rows`` are indices.

    Without rows people get all at round angles and at ``ends`` [deg] of the phases; with ``everything`` all in SI.
    Where rows or columns are left out it says so: ``example`` names columns, ``where`` the file of the whole table.
    """
    view = _view(columns, patterns, rows, ends, everything)
    fewer = rows is None and len(view.columns[0]) < len(columns["i"])
    notes = (*told.notes, LEFT_OUT) if fewer else told.notes
    return replace(told, notes=notes, table=view, wide=not patterns, more=more(where, example))


def with_further(
    columns: Mapping[str, np.ndarray], patterns: Sequence[str], further: Sequence[Column]
) -> Mapping[str, np.ndarray]:
    """The columns by their headers with those of ``further`` that a pattern names and that are not among them."""
    headers = {each.name if each.unit == "-" else each.header: each for each in further}
    known = {name for header in columns for name in (header, header.partition("[")[0])}
    asked = [pattern for pattern in patterns if not any(fnmatchcase(name, pattern) for name in known)]
    chosen = {
        header: each.make()
        for header, each in headers.items()
        if any(pattern == header or fnmatchcase(each.name, pattern) for pattern in asked)
    }
    return {**columns, **chosen}


def _view(
    columns: Mapping[str, np.ndarray],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    ends: Sequence[float],
    everything: bool,
) -> View:
    chosen = picked(columns, patterns)
    view = plain(chosen) if everything else drawn(chosen)
    if rows is None:
        rows = range(len(columns["i"])) if everything else told_rows(columns[PHI.key], ends)
    peaks = [max((abs(v) for v in column if isinstance(v, float)), default=0.0) for column in view.columns]
    return View(view.headers, [[column[k] for k in rows] for column in view.columns], () if everything else peaks)


def told_rows(phi: np.ndarray, ends: Sequence[float]) -> list[int]:
    """Indices of some forty rows: all, or those at round angles and at the ends of phases [deg].

    >>> len(told_rows(np.arange(361.0), [0.0, 47.0, 360.0]))
    38
    """
    if len(phi) <= ROWS:
        return list(range(len(phi)))
    at_end = np.min(np.abs(phi[:, None] - np.asarray(ends)), axis=1) < NEAR
    for step in STEPS:
        kept = at_end | (np.abs(phi / step - np.round(phi / step)) < NEAR)
        if np.count_nonzero(kept) <= ROWS:
            break
    return [int(k) for k in np.flatnonzero(kept)]
