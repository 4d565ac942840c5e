"""What a result leaves: its stored form for later stages, and its table for people."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Any, overload

from tmmcalc.core.records import record

if TYPE_CHECKING:
    import numpy as np


@record
class Record:
    """The stored form of a result: values for TOML and arrays for npz.

    ``scalars``, ``error`` and ``counters`` may hold floats, integers, strings, booleans, lists and dicts
    with string keys; numpy scalars and tuples are converted. A table keeps the order of its keys, except
    that values come before sub-tables.
    """

    scalars: Mapping[str, Any] = field(default_factory=dict)
    arrays: Mapping[str, np.ndarray[Any, Any]] = field(default_factory=dict)
    error: Mapping[str, Any] = field(default_factory=dict)  # error estimate
    counters: Mapping[str, Any] = field(default_factory=dict)  # steps, iterations, evaluations


class DeferredColumns(Sequence["np.ndarray[Any, Any]"]):
    """Columns of a table, each an array (n,) or what makes it when asked for: no long table is made whole."""

    def __init__(self, makers: Sequence[np.ndarray[Any, Any] | Callable[[], np.ndarray[Any, Any]]]) -> None:
        self._makers = makers

    def __len__(self) -> int:
        return len(self._makers)

    @overload
    def __getitem__(self, k: int) -> np.ndarray[Any, Any]: ...
    @overload
    def __getitem__(self, k: slice) -> Sequence[np.ndarray[Any, Any]]: ...
    def __getitem__(self, k: int | slice) -> Any:
        if isinstance(k, slice):
            return DeferredColumns(self._makers[k])
        maker = self._makers[k]
        return maker() if callable(maker) else maker

    def those(self, chosen: Sequence[int]) -> DeferredColumns:
        """Some of them; none is made."""
        return DeferredColumns([self._makers[k] for k in chosen])


@record
class Table:
    """Columns for people: ``header`` such as ``phi[deg]`` and one array of shape (n,) for each.

    The first column says what a row is.
    """

    header: list[str]
    columns: Sequence[np.ndarray[Any, Any]]

    @property
    def rows(self) -> int:
        """Number of rows; 0 for a table without columns."""
        return len(self.columns[0]) if self.columns else 0

    def selected(self, patterns: Sequence[str]) -> Table | None:
        """The first column and those whose names, or headers, match; None if none does; all without patterns."""
        if not patterns:
            return self
        kept = [k for k, header in enumerate(self.header) if any(matches(header, pattern) for pattern in patterns)]
        if not kept:
            return None
        kept = sorted({0, *kept})
        own = self.columns
        chosen = own.those(kept) if isinstance(own, DeferredColumns) else [own[k] for k in kept]
        return Table([self.header[k] for k in kept], chosen)


def matches(header: str, pattern: str) -> bool:
    """Whether a pattern such as ``x_*`` names a column.

    >>> matches("x_C[m]", "x_*"), matches("x_C[m]", "x_C[m]"), matches("x_C[m]", "C")
    (True, True, False)
    """
    return header == pattern or fnmatchcase(header.partition("[")[0], pattern)


LAST_DIGIT = "last_digit"  # key in an error estimate of what the last digit of the data does, which is no error


def estimates(error: Mapping[str, Any]) -> Iterator[tuple[str, float]]:
    """Quantities and their estimated relative errors; what else stands there says how they were found."""
    for name, value in error.items():
        if name == LAST_DIGIT:
            continue
        if isinstance(value, Mapping):
            yield from ((f"{name}.{inner}", size) for inner, size in estimates(value))
        elif isinstance(value, float):
            yield name, value


def last_digits(error: Mapping[str, Any]) -> Iterator[tuple[str, float]]:
    """Quantities and their relative change by a unit in the last place of the data; nothing where it is small."""
    yield from estimates(error.get(LAST_DIGIT, {}))
