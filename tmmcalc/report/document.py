"""The document that a command prints: titled facts, notes, one table.

A fact has a text for people and values for programs, so that ``--format json`` loses no digit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

Value = float | int | str | bool | None


@dataclass(frozen=True)
class Fact:
    """One line of a summary: a label and a text for people, named values for programs."""

    label: str
    text: str
    values: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class View:
    """A table: headers such as ``phi[deg]`` and columns of equal length, numbers or strings."""

    headers: Sequence[str]
    columns: Sequence[Sequence[Any]]


@dataclass(frozen=True)
class Document:
    """A titled summary with notes and a table; ``hidden`` says what the table does not show."""

    title: str
    facts: tuple[Fact, ...] = ()
    notes: tuple[str, ...] = ()
    table: View | None = None
    wide: bool = False  # the table may be cut to the width of the terminal
    more: str = ""  # said under a table that was cut
