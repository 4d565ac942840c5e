"""The table of positions that several stages print: columns chosen by name, rows chosen by position."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.columns import Column, select
from tmmcalc.report.document import View


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
    names = {"i": "", **{c.header: c.name for c in available}}
    wanted = [name for name in (names.get(p, p) for p in patterns) if name]
    chosen = select(available, wanted) if patterns else usual
    kept = range(len(labels)) if rows is None else rows
    values = [c.make() for c in chosen]
    return View(
        ["i", *(c.header for c in chosen)],
        [[labels[k] for k in kept], *([float(v[k]) for k in kept] for v in values)],
        [0.0, *(float(abs(v).max()) for v in values)],
    )


def more(where: str, example: str = "phi,x_*") -> str:
    """What is said under a table that was cut to the width of the terminal."""
    return f"choose with --columns, e.g. --columns '{example}'{f', or see {where}' if where else ''}"
