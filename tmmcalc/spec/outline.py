"""A defensive view of the raw document, for the checks that reach across tables.

The checks run whether or not the tables are well formed, so that all faults come in one report. What is not of the
right type is taken as absent: its own fault is pydantic's to report.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from typing import Any, NamedTuple, TypeGuard, TypeVar

from tmmcalc.core.records import record
from tmmcalc.spec.phrases import Path

Raw = dict[str, Any]
Made = TypeVar("Made")


class Rows(NamedTuple):
    """What was read: the file as the spec names it, the line of each row, and one of the unit of x."""

    file: str
    lines: list[int]
    unit: str  # such as "1 deg"; empty for plain numbers


@record
class Outline:
    """The document as written, the line of each place, and the CSV files that were read."""

    document: Raw
    line_of: Callable[[Path], int | None]
    rows: Mapping[Path, Rows] = field(default_factory=dict)
    _made: dict[Any, Any] = field(default_factory=dict)

    def once(self, make: Callable[[Outline], Made]) -> Made:
        """Return what a room makes of the document, made once for all checks."""
        if make not in self._made:
            self._made[make] = make(self)
        found: Made = self._made[make]
        return found

    def at_line(self, path: Path) -> str:
        """Return " (line 40)" for a place, or nothing if it has no line."""
        line = self.line_of(path)
        return f" (line {line})" if line is not None else ""


def tables(table: Raw, key: str) -> list[tuple[int, Raw]]:
    """Return the elements of an array of tables that are tables, each with its index."""
    listed = table.get(key)
    return [(i, item) for i, item in enumerate(listed) if isinstance(item, dict)] if isinstance(listed, list) else []


def subtable(table: Raw, key: str) -> Raw:
    """Return a subtable, an empty one if there is none."""
    found = table.get(key)
    return found if isinstance(found, dict) else {}


def word(table: Raw, key: str, otherwise: str = "") -> str:
    """Return a text of a table; ``otherwise`` if it is absent or no text."""
    found = table.get(key, otherwise)
    return found if isinstance(found, str) else otherwise


def is_integer(value: object) -> TypeGuard[int]:
    """Return whether a TOML value is an integer (a boolean is not)."""
    return isinstance(value, int) and not isinstance(value, bool)
