"""A spec as text in which some keys have other values; whatever is not changed stays as it is, byte for byte.

What goes is not lost: its lines stay as comments, so that the spec still tells what was asked. New keys stand after the
last one of their table, in its unit and with its indent.
"""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from copy import deepcopy
from json import dumps
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.spec.phrases import Path, show_key, show_path
from tmmcalc.spec.source import Source, Value
from tmmcalc.spec.units import dimension_of, unit_of, written

Raw = dict[str, Any]


@record
class Change:
    """A key of a spec and its new value; None: the key, or the table, goes."""

    path: Path
    value: Any = None
    unit: str = ""  # of a value in SI that is a quantity, where the spec writes no other one of its kind


@record
class Found:
    """What a stage found, as keys of the spec."""

    changes: tuple[Change, ...]
    tables: str = ""  # TOML text of tables, which stand in the place of the first table that goes
    of: str = ""  # which of several solutions it is, in words
    ends: tuple[str, ...] = ()  # stages that the new spec has no longer
    alone: Any = None  # of several solutions the result with this one; None: there is but one


def toml(value: object) -> str:
    """A value as TOML writes it on one line, numbers with all their digits.

    >>> toml([1, "a", True, {"x": 0.1}])
    '[1, "a", true, { x = 0.1 }]'
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{show_key(key)} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(toml, value)) + "]"
    return repr(value)


def value_at(document: Raw, path: Path) -> Any:
    """What a document has at a path; None if it has nothing there."""
    here: Any = document
    for step in path:
        try:
            here = here[step]
        except (KeyError, IndexError, TypeError):
            return None
    return here


def worded(document: Raw, change: Change) -> Any:
    """The value of a change as this document would write it: a quantity in the unit of its like."""
    if not change.unit or change.value is None:
        return change.value
    old, kind = value_at(document, change.path), dimension_of(f"1 {change.unit}")
    if isinstance(old, int | float) and not isinstance(old, bool):
        return change.value
    for table in (value_at(document, change.path[:-1]), value_at(document, change.path[:1])):
        alike = (old, *table.values()) if isinstance(table, dict) else (old,)
        for value in alike:
            if dimension_of(value) == kind:
                return written(change.value, unit_of(value))
    return written(change.value, change.unit)


def changed(document: Raw, changes: Sequence[Change], tables: str = "") -> Raw:
    """A document with the changes, their values as it would write them, and with further tables."""
    made = deepcopy(document)
    for change in changes:
        if change.value is None:
            continue
        *above, key = change.path
        here: Any = made
        for step in above:
            here = here.setdefault(step, {}) if isinstance(here, dict) else here[step]
        here[key] = worded(document, change)
    for path in _going(changes):
        if value_at(made, path) is not None:
            del value_at(made, path[:-1])[path[-1]]
    return {**made, **tomllib.loads(tables)}


def _going(changes: Sequence[Change]) -> list[Path]:
    """The keys and tables that go, the last element of a list first: the others keep their places so long."""
    paths = (change.path for change in changes if change.value is None)
    return sorted(paths, key=lambda path: [(isinstance(step, int) and step, str(step)) for step in path], reverse=True)


def rewritten(text: str, changes: Sequence[Change], tables: str = "") -> str:
    """A TOML text with the changes.

    Raises UsageError where the text is written in a way that does not let them in.
    """
    document = tomllib.loads(text)
    wanted = changed(document, changes, tables)
    for change in changes:
        if change.value is not None:
            text = _put(text, change, document)
    first = next((change.path for change in changes if change.value is None), None)
    after = None if first is None else _last_line(text, first)
    for path in _going(changes):
        text = _commented(text, path)
    if tables:
        text = _with_tables(text, tables, after)
    try:
        same = _pruned(tomllib.loads(text)) == _pruned(wanted)
    except tomllib.TOMLDecodeError:
        same = False
    if not same:
        keys = ", ".join([*(show_path(change.path) for change in changes), *tomllib.loads(tables)])
        raise UsageError(
            f"the spec is written in a way that cannot take {keys}",
            where="--spec",
            remedy="write these tables under headers of their own, such as [cam], one key a line",
        )
    return text


def without(text: str, table: str) -> str:
    """A TOML text from which a table of its root is gone, with the comments that stand in it and right above it.

    Raises UsageError where the text is written in a way that does not let it go.
    """
    document = tomllib.loads(text)
    lines, source = _lines(text), Source(text)
    begins = [text.count("\n", 0, header.begin) for header in source.headers]
    gone = set[int]()
    for header, own in enumerate(source.headers):
        if own.path[:1] == (table,):
            end = begins[header + 1] if header + 1 < len(begins) else len(lines)
            gone |= {*range(_above(lines, begins[header]), end if end == len(lines) else _above(lines, end))}
    for path, place in source.values.items():
        if path[0] == table and not place.inline and place.home < 0:
            gone |= {*range(text.count("\n", 0, place.begin), text.count("\n", 0, place.end) + 1)}
    made = "".join(line for number, line in enumerate(lines) if number not in gone).rstrip() + _mark(text)
    if tomllib.loads(made) != {key: value for key, value in document.items() if key != table}:
        rule = f"[{table}] is written in a way that does not let it go"
        raise UsageError(rule, remedy="write it under headers of its own, one key a line")
    return made


def _above(lines: Sequence[str], number: int) -> int:
    """The first of the comments that stand right above a line, or that line."""
    while number > 0 and lines[number - 1].lstrip().startswith("#"):
        number -= 1
    return number


def _pruned(value: Any) -> Any:
    """A document without tables and lists that hold nothing: a header without keys says no more than none."""
    if isinstance(value, dict):
        kept = {key: _pruned(item) for key, item in value.items()}
        return {key: item for key, item in kept.items() if item not in ({}, [])}
    return [_pruned(item) for item in value] if isinstance(value, list) else value


def _put(text: str, change: Change, document: Raw) -> str:
    """The text with a value in place of the old one, or with a new key."""
    source, value = Source(text), toml(worded(document, change))
    place = source.values.get(change.path)
    if place is not None:
        return text[: place.value] + value + text[place.end :]
    if change.path in source.begins:  # a table with headers, or of dotted keys
        text = _commented(text, change.path)
    return _added(text, change.path, value)


def _added(text: str, path: Path, value: str) -> str:
    """The text with a new key in the table that its path leads to, the nearest of its parents that is there."""
    source = Source(text)
    for count in range(len(path) - 1, 0, -1):
        parent = path[:count]
        named = f"{'.'.join(show_key(str(step)) for step in path[count:])} = {value}"
        if parent in source.values:
            return _inline(text, source.values[parent], named)
        headers = [index for index, header in enumerate(source.headers) if header.path == parent]
        own = [place for _, place in _pairs(source, parent)]
        if headers and count == len(path) - 1:
            of_header = [place for place in source.values.values() if place.home == headers[-1] and not place.inline]
            end = of_header[-1].end if of_header else source.headers[headers[-1]].end
            begin = of_header[-1].begin if of_header else source.headers[headers[-1]].begin
            return _line_after(text, end, _indent(text, begin) + named)
        dotted = [place for place in own if not _is_under(source, place, parent)]
        if dotted:
            last = dotted[-1]
            above = source.headers[last.home].path if last.home >= 0 else ()
            name = ".".join(show_key(str(step)) for step in path[len(above) :])
            return _line_after(text, last.end, f"{_indent(text, last.begin)}{name} = {value}")
        if headers:
            break
    header = ".".join(show_key(step) for step in path[:-1] if isinstance(step, str))
    block = f"[{header}]\n{show_key(str(path[-1]))} = {value}\n" if header else f"{show_key(str(path[-1]))} = {value}\n"
    element = max((place + 1 for place, step in enumerate(path) if isinstance(step, int)), default=1)
    return _with_tables(text, block, _last_line(text, path[:element]))


def _pairs(source: Source, table: Path) -> Iterator[tuple[Path, Value]]:
    """The keys of a table and of those in it that stand on lines of their own."""
    for path, place in source.values.items():
        if path[: len(table)] == table and not place.inline:
            yield path, place


def _is_under(source: Source, place: Value, table: Path) -> bool:
    """Whether a key stands under a header of this table, or of one in it."""
    return place.home >= 0 and source.headers[place.home].path[: len(table)] == table


def _inline(text: str, place: Value, named: str) -> str:
    """The text with a further key in an inline table."""
    body = text[place.value + 1 : place.end - 1].rstrip()
    filled = f"{body}, {named} " if body.strip() else f" {named} "
    return f"{text[: place.value + 1]}{filled}{text[place.end - 1 :]}"


def _commented(text: str, path: Path) -> str:
    """The text in which the lines of a key, or of a table and all in it, are comments."""
    source = Source(text)
    place = source.values.get(path)
    if place is not None and place.inline:
        return _cut(text, place)
    lines = _lines(text)
    for begin, end in _stretches(source, path):
        for number in range(text.count("\n", 0, begin), text.count("\n", 0, end) + 1):
            if lines[number].strip() and not lines[number].lstrip().startswith("#"):
                lines[number] = f"# {lines[number]}"
    return "".join(lines)


def _cut(text: str, place: Value) -> str:
    """The text without a key of an inline table, and without one of the commas beside it."""
    rest = text[place.end :]
    if rest.lstrip().startswith(","):
        return text[: place.begin] + rest.lstrip().removeprefix(",").lstrip()
    return text[: place.begin].rstrip().removesuffix(",") + rest


def _stretches(source: Source, path: Path) -> list[tuple[int, int]]:
    """Begin and end of the headers of a table and of all keys in it, or of a key."""
    headers = [(header.begin, header.end) for header in source.headers if header.path[: len(path)] == path]
    return [*headers, *((place.begin, place.end) for _, place in _pairs(source, path))]


def _last_line(text: str, table: Path) -> int | None:
    """The last line, from 0, of what stands under the headers of a table; None if it has none."""
    source = Source(text)
    ends = [
        end
        for begin, end in _stretches(source, table)
        if table
        and (home := bisect_right([header.begin for header in source.headers], begin)) > 0
        and source.headers[home - 1].path[: len(table)] == table
    ]
    return text.count("\n", 0, max(ends)) if ends else None


def _with_tables(text: str, tables: str, after: int | None) -> str:
    """The text with further tables after a line, apart by a blank one; None: at its end."""
    lines = _lines(text)
    at = len(lines) if after is None else after + 1
    head, tail = "".join(lines[:at]), "".join(lines[at:])
    mark = _mark(text)
    if head and not head.endswith("\n"):
        head += mark
    block = mark.join(tables.rstrip("\n").split("\n")) + mark
    if tail.strip() and not tail.startswith(("\n", "\r\n")):
        block += mark
    return head + (mark if head.strip() else "") + block + tail


def _line_after(text: str, end: int, line: str) -> str:
    """The text with a further line after the one in which a place stands."""
    at, mark = text.find("\n", end) + 1, _mark(text)
    if not at:
        return f"{text}{mark}{line}{mark}"
    return f"{text[:at]}{line}{mark}{text[at:]}"


def _lines(text: str) -> list[str]:
    """The lines as TOML counts them, each with its end."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)


def _mark(text: str) -> str:
    """How the lines of a text end."""
    return "\r\n" if "\r\n" in text else "\n"


def _indent(text: str, begin: int) -> str:
    """What stands before a place in its line, if that is blank."""
    before = text[text.rfind("\n", 0, begin) + 1 : begin]
    return before if not before.strip() else ""
