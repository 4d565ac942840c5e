"""Answers in TOML: ``name = value`` at the top or in one table; a table a student for a whole class."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.classroom.answers.layouts import STUDENT, Entry, Table
from tmmcalc.classroom.answers.limits import COLUMNS, DEEPEST, ROWS, WIDEST, UnreadableError
from tmmcalc.classroom.answers.naming import Names, Roster, folded
from tmmcalc.core.errors import SpecError
from tmmcalc.core.notes import Phrase
from tmmcalc.spec.syntax import read_toml

_STUDENT = {folded(word) for word in STUDENT}


def entries_of_toml(text: str, names: Names, roster: Roster) -> Table:
    """What stands in a TOML text; raises `UnreadableError`."""
    try:
        read_toml(text, "")  # which tells faults in plain words
        document = tomllib.loads(text.removeprefix("\ufeff"), parse_float=str)  # as written: its figures count
    except (SpecError, RecursionError, ValueError) as error:
        first = error.faults[0].message if isinstance(error, SpecError) and error.faults else "it is nested too deeply"
        raise UnreadableError(f"is no TOML: {first}", "write lines such as H = 0.12") from None
    student, found, unknown = "", list[Entry](), list[str]()
    for path, key, value in _leaves(document, ()):
        if len(found) + len(unknown) > ROWS + COLUMNS:
            raise UnreadableError(f"has more than {ROWS} values", "hand in the answers alone")
        who = next((table for table in path if roster.student(table) is not None), "")
        if folded(key) in _STUDENT:
            student = _shown(value)
        elif (item := names.headed(key)) and item[0] is not None:
            found.append(Entry(who, item[0], _shown(value), item[1], Phrase("key {key}", key=key)))
        else:
            unknown.append(key)
    if not found:
        raise UnreadableError("names no result that is asked", "write the names of the results as in the task")
    return Table(tuple(found), student, tuple(unknown))


def _leaves(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str, Any]]:
    """Keys with their values, and the tables in which they stand."""
    for key, value in table.items():
        if isinstance(value, dict) and len(path) < DEEPEST and not {"value", "unit"} >= value.keys():
            yield from _leaves(value, (*path, key))
        else:
            yield path, key, value


def _shown(value: Any) -> str:
    """A value as text: a number with its figures, a table of value and unit as both."""
    if isinstance(value, dict):
        return f"{_shown(value.get('value', ''))} {_shown(value.get('unit', ''))}".strip()
    if isinstance(value, bool | list):
        return "true or false" if isinstance(value, bool) else "a list"
    text = str(value)
    return text if len(text) <= WIDEST else text[:WIDEST]
