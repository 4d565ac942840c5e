"""Columns of tables: a name and a unit for each quantity, everywhere the same; and how they are chosen by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fnmatch import fnmatchcase
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.errors import UsageError

Real = NDArray[np.floating[Any]]


class Column(NamedTuple):
    """A named quantity (n,) with its unit."""

    name: str
    unit: str
    make: Callable[[], Real]

    @property
    def header(self) -> str:
        """``name[unit]``."""
        return f"{self.name}[{self.unit}]"


def degrees(phi: Real) -> Real:
    """Degrees of the grid, where a step of 15 is 15 and not 14.999999999999998."""
    degrees = np.degrees(phi)
    near = np.round(degrees, 9)
    return np.where(np.abs(degrees - near) <= 4 * np.spacing(np.abs(degrees)), near, degrees)


def select(available: Sequence[Column], patterns: Sequence[str]) -> list[Column]:
    """Columns whose names match the patterns (``x_*``, ``omega_3``), in the order of the patterns.

    Raises `UsageError` for a pattern that matches nothing, with the nearest names.
    """
    chosen: list[Column] = []
    for pattern in patterns:
        found = [column for column in available if fnmatchcase(column.name, pattern)]
        if not found:
            raise UsageError(f"no column is called {pattern!r}", where="--columns", remedy=_nearest(available, pattern))
        chosen += [column for column in found if column not in chosen]
    return chosen


def _nearest(available: Sequence[Column], pattern: str) -> str:
    from difflib import get_close_matches

    names = [column.name for column in available]
    close = get_close_matches(pattern, names, 3, 0.5)
    return f"did you mean {', '.join(close)}?" if close else f"columns: {', '.join(names)}"
