"""Tables of several layouts one under the other: what a layout has not is blank in its rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

FIRST = ("i", "layout", "K")  # headers that come first, before the wheels in their order
WHEEL = "z_"


def joined(tables: Sequence[Mapping[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """The columns of all tables by their headers; a column that one of them lacks is text.

    >>> both = joined([{"K": np.array([3]), "z_1": np.array([17])}, {"K": np.array([4])}])
    >>> both["K"].tolist(), both["z_1"].tolist()
    ([3, 4], ['17', ''])
    """
    headers = dict.fromkeys(header for table in tables for header in table)
    return {header: _column(header, tables) for header in sorted(headers, key=_place)}


def _place(header: str) -> tuple[int, str]:
    """Wheels by their names, which are in their order: 1, 2, 2', 3; everything else as it comes."""
    return (1, header) if header.startswith(WHEEL) else (0 if header in FIRST else 2, "")


def _column(header: str, tables: Sequence[Mapping[str, np.ndarray]]) -> np.ndarray:
    if all(header in table for table in tables):
        return np.concatenate([table[header] for table in tables])
    parts = (_texts(table[header]) if header in table else np.full(_rows(table), "") for table in tables)
    return np.concatenate([*parts])


def _texts(column: np.ndarray) -> np.ndarray:
    """Numbers with every digit."""
    return np.array([value if isinstance(value, str) else repr(value) for value in column.tolist()], dtype=np.str_)


def _rows(table: Mapping[str, np.ndarray]) -> int:
    return len(next(iter(table.values())))
