"""Where every key and value of a TOML text stands: its line and column, its characters.

tomllib gives values without their places. This scanner walks the same text, which tomllib has already
accepted, and notes where each table header, key, array element and inline key begins. It is
therefore free to look only at structure: strings, comments and brackets.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from functools import cached_property
from typing import NamedTuple

from tmmcalc.spec.phrases import Path

_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_STRING = re.compile(
    r'"""(?:[^\\]|\\.)*?"{3,5}'  # the first three quotes in a row end it; up to two before them belong to it
    r"|'''.*?'{3,5}"
    r'|"(?:[^"\\]|\\.)*"'
    r"|'[^']*'",
    re.DOTALL,
)
_BARE_VALUE = re.compile(r"[^,\]}#\r\n]*")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_KEY_DOT = re.compile(r"[ \t]*\.[ \t]*")


class Value(NamedTuple):
    """The characters of a value and of what names it, as slices of the text."""

    begin: int  # of its key; of an element of an array of the value itself
    value: int
    end: int
    home: int  # header under which it stands, by its place among them; -1: before the first
    inline: bool  # within a list or an inline table


class Header(NamedTuple):
    """A table header."""

    path: Path
    begin: int
    end: int


class Source:
    """Places in a TOML text. ``text`` must be valid TOML; it is scanned when a place is first asked for."""

    def __init__(self, text: str) -> None:
        self._text = text

    @cached_property
    def _scanned(self) -> _Scan:
        scan = _Scan(self._text)
        scan.run()
        return scan

    @property
    def begins(self) -> dict[Path, int]:
        """Characters before each path of the document."""
        return self._scanned.begins

    @property
    def values(self) -> dict[Path, Value]:
        """Where each value stands that is written by a key or is an element of a list, in the order of the text."""
        return self._scanned.values

    @property
    def headers(self) -> list[Header]:
        """The table headers in the order of the text."""
        return self._scanned.headers

    @cached_property
    def _line_ends(self) -> list[int]:
        return [match.start() for match in re.finditer("\n", self._text)]

    def place_of(self, path: Path) -> tuple[int, int] | None:
        """Return line and column, from 1, of a path, or of its nearest parent that exists; None for the document."""
        for length in range(len(path), 0, -1):
            at = self.begins.get(path[:length])
            if at is not None:
                line = bisect_right(self._line_ends, at)
                before = self._line_ends[line - 1] if line else _marks(self._text) - 1
                return line + 1, at - before
        return None

    def line_of(self, path: Path) -> int | None:
        """Return the line of `place_of`."""
        place = self.place_of(path)
        return None if place is None else place[0]


def _marks(text: str) -> int:
    """Characters before the text itself: a byte order mark."""
    return int(text.startswith("\ufeff"))


class _Scan:
    """One walk over the text: ``at`` is the next character, the rest what was found so far."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = _marks(text)
        self.begins: dict[Path, int] = {}
        self.values: dict[Path, Value] = {}
        self.headers: list[Header] = []
        self.depth = 0  # of lists and inline tables
        self.elements: dict[Path, int] = {}  # arrays of tables: how many elements have begun

    def run(self) -> None:
        table: Path = ()
        while self._skip_blank():
            if self.text[self.at] == "[":
                table = self._header()
            else:
                self._pair(table)

    def _header(self) -> Path:
        begin = self.at
        is_array = self.text.startswith("[[", self.at)
        self.at += 2 if is_array else 1
        self._skip_blank()
        keys = self._keys()
        self._skip_blank()
        self.at += 2 if is_array else 1
        path = (*self._note_parents((), keys[:-1], begin), keys[-1])
        if is_array:
            self.begins.setdefault(path, begin)
            index = self.elements.get(path, 0)
            self.elements[path] = index + 1
            path += (index,)
        # A header states where its table is, even if a subtable stood before it.
        self.begins[path] = begin
        self.headers.append(Header(path, begin, self.at))
        return path

    def _note_parents(self, base: Path, keys: list[str], begin: int) -> Path:
        """Note the tables that a dotted key opens; an array of tables stands for its last element."""
        path = base
        for key in keys:
            path += (key,)
            self.begins.setdefault(path, begin)
            if path in self.elements:
                path += (self.elements[path] - 1,)
        return path

    def _pair(self, table: Path) -> None:
        begin = self.at
        keys = self._keys()
        path = (*self._note_parents(table, keys[:-1], begin), keys[-1])
        self.begins[path] = begin
        self._skip_blank()
        self.at += 1  # the equals sign
        self._skip_blank()
        self._value(path, begin)

    def _value(self, path: Path, begin: int) -> None:
        value = self.at
        self._take_value(path)
        end = value + len(self.text[value : self.at].rstrip())
        self.values[path] = Value(begin, value, end, len(self.headers) - 1, self.depth > 0)

    def _take_value(self, path: Path) -> None:
        opening = self.text[self.at]
        if opening == "[":
            self._array(path)
        elif opening == "{":
            self._inline_table(path)
        elif opening in "\"'":
            self._take(_STRING)
        else:
            self._take(_BARE_VALUE)

    def _array(self, path: Path) -> None:
        index = 0
        self.depth += 1
        while self._next_item("]"):
            self.begins[(*path, index)] = self.at
            self._value((*path, index), self.at)
            index += 1
        self.depth -= 1

    def _inline_table(self, path: Path) -> None:
        self.depth += 1
        while self._next_item("}"):
            self._pair(path)
        self.depth -= 1

    def _next_item(self, closing: str) -> bool:
        """Step over the opening bracket or a comma; False, and past the closing bracket, at the end."""
        self._skip_blank()
        if self.text[self.at] != closing:
            self.at += 1
            self._skip_blank()
        if self.text[self.at] != closing:
            return True
        self.at += 1
        return False

    def _keys(self) -> list[str]:
        keys = [self._key()]
        while dot := _KEY_DOT.match(self.text, self.at):
            self.at = dot.end()
            keys.append(self._key())
        return keys

    def _key(self) -> str:
        if self.text[self.at] in "\"'":
            return _unquoted(self._take(_STRING))
        return self._take(_BARE_KEY)

    def _take(self, pattern: re.Pattern[str]) -> str:
        match = pattern.match(self.text, self.at)
        if match is None:
            raise ValueError(f"not the TOML that tomllib accepts, at character {self.at}")
        self.at = match.end()
        return match.group()

    def _skip_blank(self) -> bool:
        self._take(_BLANK)
        return self.at < len(self.text)


def _unquoted(key: str) -> str:
    if key.startswith("'") or "\\" not in key:
        return key[1:-1]
    import tomllib  # late: keys with escapes are rare

    name: str = next(iter(tomllib.loads(f"{key} = 0")))
    return name
