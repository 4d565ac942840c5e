"""Columns of tables: a name and a unit for each quantity, everywhere the same; and how they are chosen by name."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import partial
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import Quantity, quantities

Real = NDArray[np.floating[Any]]
Values = TypeVar("Values")


class Column(NamedTuple):
    """A named quantity (n,) with its unit."""

    name: str
    unit: str
    make: Callable[[], Real]

    @property
    def header(self) -> str:
        """``name[unit]``."""
        return f"{self.name}[{self.unit}]"

    def shown(self, unit: str) -> tuple[str, float]:
        """The header in a unit for people, and the factor of the values."""
        return Quantity(self.header, "").shown(unit)


def column(told: Quantity, make: Callable[[], Real]) -> Column:
    """The column of a quantity; one that is a number has the unit ``-``."""
    return Column(told.name, told.unit or "-", make)


def columns_of(of: Any, *names: str) -> list[Column]:
    """Columns of the fields of a record that are arrays (n,): of these, or of all; one that is None has no column."""
    known = quantities(type(of))
    arrays = (name for name in names or known if isinstance(getattr(of, name), np.ndarray))
    return [column(known[name], partial(getattr, of, name)) for name in arrays]


def degrees(phi: Real) -> Real:
    """Degrees of the grid, where a step of 15 is 15 and not 14.999999999999998."""
    degrees = np.degrees(phi)
    near = np.round(degrees, 9)
    return np.where(np.abs(degrees - near) <= 4 * np.spacing(np.abs(degrees)), near, degrees)


def select(available: Sequence[Column], patterns: Sequence[str], labels: str = "i") -> list[Column]:
    """Columns that the patterns name (``x_*``, ``omega_3``, or the header), in the order of the patterns.

    ``labels`` is the name of the column that every row begins with, chosen or not.
    Raises `UsageError` for a pattern that matches nothing, with the nearest names.
    """
    headers = {column.header: column.name for column in available}
    by_name = {column.name: column for column in available}
    wanted = [headers.get(pattern, pattern) for pattern in patterns]
    return [by_name[name] for name in _matching(by_name, [name for name in wanted if name != labels])]


def picked(columns: Mapping[str, Values], patterns: Sequence[str], labels: str = "i") -> dict[str, Values]:
    """Of columns by their headers those that `select` would choose, after that of ``labels``; all without patterns.

    >>> picked({"i": 0, "phi[deg]": 1, "x_A[m]": 2, "x_B[m]": 3}, ["x_*"])
    {'i': 0, 'x_A[m]': 2, 'x_B[m]': 3}
    """
    if not patterns:
        return dict(columns)
    names = {header.partition("[")[0]: header for header in columns if header != labels}
    wanted = [pattern.partition("[")[0] if pattern in columns else pattern for pattern in patterns]
    chosen = [names[name] for name in _matching(names, [name for name in wanted if name != labels])]
    return {header: columns[header] for header in [*([labels] if labels in columns else []), *chosen]}


def _matching(names: Collection[str], patterns: Sequence[str]) -> list[str]:
    """The names that match, each once, in the order of the patterns."""
    chosen: dict[str, None] = {}
    for pattern in patterns:
        found = [name for name in names if fnmatchcase(name, pattern)]
        if not found:
            raise UsageError(f"no column is called {pattern!r}", where="--columns", remedy=nearest(names, pattern))
        chosen |= dict.fromkeys(found)
    return list(chosen)


def nearest(names: Collection[str], pattern: str) -> str:
    """Names like a pattern that matches nothing, for the remedy of the error."""
    from difflib import get_close_matches

    close = get_close_matches(pattern, names, 3, 0.5)
    return f"did you mean {', '.join(close)}?" if close else f"columns: {', '.join(names)}"
