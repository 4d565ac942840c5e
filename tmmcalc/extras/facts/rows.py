"""The tables of the small calculators: columns chosen by name; people get some rows of the many."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tmmcalc.core.columns import picked
from tmmcalc.report.document import Document, View
from tmmcalc.report.sizes import drawn, plain

SHOWN = 25  # rows that people get
MORE = "--positions names further rows, --format csv prints all"


def view_of(
    columns: Mapping[str, np.ndarray],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    everything: bool,
    told: Sequence[int],
) -> View:
    """The table of chosen columns; people get the rows that are told, in the units of a drawing."""
    chosen = picked(columns, patterns)
    whole = plain(chosen) if everything else drawn(chosen)
    if rows is None:
        rows = range(len(columns["i"])) if everything else told
    peaks = [max((abs(v) for v in column if isinstance(v, float)), default=0.0) for column in whole.columns]
    return View(whole.headers, [[column[k] for k in rows] for column in whole.columns], () if everything else peaks)


def even(count: int) -> list[int]:
    """Indices of some rows at equal steps, the first and the last among them."""
    return sorted({round(k * (count - 1) / (SHOWN - 1)) for k in range(SHOWN)})


def with_table(summary: Document, view: View, complete: bool) -> Document:
    """The summary with its table."""
    return Document(summary.title, summary.facts, summary.notes, view, more="" if complete else MORE)
