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
    meaning: str = ""  # a few English words, as they are declared
    symbol: str = ""

    @property
    def header(self) -> str:
        """``name[unit]``."""
        return f"{self.name}[{self.unit}]"

    def shown(self, unit: str) -> tuple[str, float]:
        """The header in a unit for people, and the factor of the values."""
        return Quantity(self.header, "").shown(unit)


def column(told: Quantity, make: Callable[[], Real]) -> Column:
    """The column of a quantity; one that is a number has the unit ``-``."""
    return Column(told.name, told.unit or "-", make, told.meaning, told.symbol)


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


def select(
    available: Sequence[Column], patterns: Sequence[str], labels: str = "i", further: Sequence[Column] = ()
) -> list[Column]:
    """Columns that the patterns name (``x_*``, ``omega_3``, or the header), in the order of the patterns.

    ``labels`` is the name of the column that every row begins with, chosen or not. ``further`` columns belong to no
    table by themselves: a pattern chooses among them if it names none of those that are ``available``.
    Raises `UsageError` for a pattern that matches nothing, with the nearest names.
    """
    headers = {column.header: column.name for column in (*further, *available)}
    by_name = {column.name: column for column in (*further, *available)}
    wanted = [name for name in (headers.get(pattern, pattern) for pattern in patterns) if name != labels]
    own, beside = ({column.name: column.header for column in each} for each in (available, further))
    return [by_name[name] for name in _matching(own, wanted, beside)]


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


def _matching(names: Mapping[str, str], patterns: Sequence[str], further: Mapping[str, str] | None = None) -> list[str]:
    """The names, with their headers, that match, each once, by pattern; ``further`` ones where no other does."""
    further = further or {}
    chosen: dict[str, None] = {}
    for pattern in patterns:
        found = [name for name in names if fnmatchcase(name, pattern)]
        found = found or [name for name in further if fnmatchcase(name, pattern)]
        if not found:
            known = {**names, **further}
            remedy = _another_unit(known, pattern) or nearest(known, pattern)
            raise UsageError(f"no column is called {pattern!r}", where="--columns", remedy=remedy)
        chosen |= dict.fromkeys(found)
    return list(chosen)


def _another_unit(headers: Mapping[str, str], pattern: str) -> str:
    """What a column is called that was asked for in a unit that it does not have; empty for another."""
    header = headers.get(pattern.partition("[")[0])
    return f"it is {header}" if header else ""


def nearest(names: Collection[str], pattern: str) -> str:
    """Names like a pattern that matches nothing, for the remedy of the error."""
    from difflib import get_close_matches

    close = get_close_matches(pattern, names, 3, 0.5)
    return f"did you mean {', '.join(close)}?" if close else f"columns: {', '.join(names)}"
