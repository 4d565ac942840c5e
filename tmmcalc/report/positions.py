"""The table of positions that several stages print: columns chosen by name, rows chosen by position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.core.columns import Column, select
from tmmcalc.report.document import Document, View


def with_positions(
    told: Document,
    labels: Sequence[str],
    available: Sequence[Column],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    *,
    usual: Sequence[Column] | None = None,
    example: str,
    where: str,
) -> Document:
    """The document with its table of positions, as `positions_view` makes it; ``usual`` None takes all columns.

    Where columns are cut it says so: ``example`` names columns, ``where`` the file that has them all.
    """
    shown = available if usual is None else usual
    view = positions_view(labels, available, usual=shown, patterns=patterns, rows=rows)
    return replace(told, table=view, wide=not patterns, more=more(where, example))


def positions_view(
    labels: Sequence[str],
    available: Sequence[Column],
    *,
    usual: Sequence[Column],
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
) -> View:
    """The table with the columns that ``patterns`` name (by name, header or wildcard), or else the ``usual`` ones.

    ``rows`` are indices of positions, None for all. Raises `UsageError` for a pattern that matches nothing.
    """
    chosen = select(available, patterns) if patterns else usual
    kept = range(len(labels)) if rows is None else rows
    values = [c.make() for c in chosen]
    return View(
        ["i", *(c.header for c in chosen)],
        [[labels[k] for k in kept], *([float(v[k]) for k in kept] for v in values)],
        [0.0, *(float(abs(v).max()) for v in values)],
    )


def more(where: str, example: str = "phi,x_*") -> str:
    """What is said under a table that was cut; ``example`` names columns, ``where`` the file that has them all."""
    return f"choose with --columns, e.g. --columns '{example}'{f', or see {where}' if where else ''}"
