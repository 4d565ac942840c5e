"""A table of several series under one another: each has some of the columns, the others are blank."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

Series = Mapping[str, np.ndarray]


def stacked(parts: Mapping[str, Series]) -> dict[str, np.ndarray]:
    """Columns by header, the first of them the name of the series; blanks are empty texts.

    >>> stacked({"a": {"t[s]": np.array([0.5])}, "b": {"x[m]": np.array([2.0])}})["x[m]"].tolist()
    ['', 2.0]
    """
    headers = list(dict.fromkeys(header for part in parts.values() for header in part))
    lengths = {name: len(next(iter(part.values()))) for name, part in parts.items()}
    found = {"series": np.array([name for name, count in lengths.items() for _ in range(count)])}
    for header in headers:
        if all(header in part for part in parts.values()):
            found[header] = np.concatenate([part[header] for part in parts.values()])
            continue
        cells = [part[header].tolist() if header in part else [""] * lengths[name] for name, part in parts.items()]
        found[header] = np.array([cell for column in cells for cell in column], dtype=object)
    return found


def as_text(column: np.ndarray) -> np.ndarray:
    """A column with blanks as texts of full precision; another one as it is.

    >>> as_text(np.array(["", 0.1], dtype=object)).tolist()
    ['', '0.1']
    """
    if column.dtype != object:
        return column
    return np.array([cell if isinstance(cell, str) else repr(cell) for cell in column.tolist()])
