"""The table of positions that several stages print: columns chosen by name, rows chosen by position."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.columns import Column, select
from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document, View
from tmmcalc.report.rows import listed

PRINTED = 10_000_000  # values of a table: as text they take a gigabyte


def with_positions(
    told: Document,
    labels: Sequence[str],
    available: Sequence[Column],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    *,
    usual: Sequence[Column] | None = None,
    everything: bool = False,
    example: str,
    where: str,
    further: Sequence[Column] = (),
) -> Document:
    """The document with its table of positions, as `positions_view` makes it; ``usual`` None takes all columns.

    Where columns are cut it says so: ``example`` names columns, ``where`` the file that has them all.
    """
    shown = available if usual is None else usual
    view = positions_view(
        labels, available, usual=shown, patterns=patterns, rows=rows, everything=everything, further=further
    )
    return replace(told, table=view, wide=not patterns, more=more(where, example))


def positions_view(
    labels: Sequence[str],
    available: Sequence[Column],
    *,
    usual: Sequence[Column],
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    further: Sequence[Column] = (),
) -> View:
    """The table with the columns that ``patterns`` name (by name, header or wildcard), or else the ``usual`` ones.

    ``further`` columns are those by choice, see `select`; a cell of theirs that is NaN has no value and is left empty.

    ``rows`` are indices of positions, None for all, of which people, who do not ask for ``everything``, get so many in
    even steps that they can be printed. Raises `UsageError` for a pattern that matches nothing, and for
    more values than can be printed.
    """
    chosen = select(available, patterns, further=further) if patterns else usual
    kept = listed(len(labels), everything) if rows is None else rows
    if len(kept) * len(chosen) > PRINTED:
        raise UsageError(
            f"{len(kept)} positions with {len(chosen)} columns each are more than can be printed",
            value=len(kept) * len(chosen),
            limit=PRINTED,
            remedy=f"name fewer columns (--columns 'phi,x_*'), or every {-(-len(kept) * len(chosen) // PRINTED)}th "
            "position (--positions 0:1000:10); --csv writes all of them to a file",
        )
    values = [c.make() for c in chosen]
    return View(
        ["i", *(c.header for c in chosen)],
        [[labels[k] for k in kept], *([_cell(v[k]) for k in kept] for v in values)],
        [0.0, *(float(np.nanmax(abs(v), initial=0.0)) for v in values)],
        every=kept.step if isinstance(kept, range) else 1,
    )


def _cell(value: float) -> float | str:
    """A number as it is; nothing in place of NaN."""
    return "" if math.isnan(value) else float(value)


def more(where: str, example: str = "phi,x_*") -> str:
    """What is said under a table that was cut; ``example`` names columns, ``where`` the file that has them all."""
    return f"choose with --columns, e.g. --columns '{example}'{f', or see {where}' if where else ''}"
