"""The line of every key and value of a TOML text.

tomllib gives values without their places. This scanner walks the same text, which tomllib has already
accepted, and notes the line on which each table header, key, array element and inline key begins. It is
therefore free to look only at structure: strings, comments and brackets.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from functools import cached_property

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


class Source:
    """Places in a TOML text. ``text`` must be valid TOML; it is scanned when a line is first asked for."""

    def __init__(self, text: str) -> None:
        self._text = text

    @cached_property
    def lines(self) -> dict[Path, int]:
        """The 1-based line on which each path of the document begins."""
        return _Scan(self._text).run()

    def line_of(self, path: Path) -> int | None:
        """Return the line of a path, or of its nearest parent that exists; None for the document itself."""
        for length in range(len(path), 0, -1):
            if path[:length] in self.lines:
                return self.lines[path[:length]]
        return None


class _Scan:
    """One walk over the text: ``at`` is the next character, ``lines`` what was found so far."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 1 if text.startswith("\ufeff") else 0
        self.line_ends = [match.start() for match in re.finditer("\n", text)]
        self.lines: dict[Path, int] = {}
        self.elements: dict[Path, int] = {}  # arrays of tables: how many elements have begun

    def run(self) -> dict[Path, int]:
        table: Path = ()
        while self._skip_blank():
            if self.text[self.at] == "[":
                table = self._header()
            else:
                self._pair(table)
        return self.lines

    def _header(self) -> Path:
        line = self._line()
        is_array = self.text.startswith("[[", self.at)
        self.at += 2 if is_array else 1
        self._skip_blank()
        keys = self._keys()
        self._skip_blank()
        self.at += 2 if is_array else 1
        path = (*self._note_parents((), keys[:-1], line), keys[-1])
        if is_array:
            self.lines.setdefault(path, line)
            index = self.elements.get(path, 0)
            self.elements[path] = index + 1
            path += (index,)
        # A header states where its table is, even if a subtable stood before it.
        self.lines[path] = line
        return path

    def _note_parents(self, base: Path, keys: list[str], line: int) -> Path:
        """Note the tables that a dotted key opens; an array of tables stands for its last element."""
        path = base
        for key in keys:
            path += (key,)
            self.lines.setdefault(path, line)
            if path in self.elements:
                path += (self.elements[path] - 1,)
        return path

    def _pair(self, table: Path) -> None:
        line = self._line()
        keys = self._keys()
        path = (*self._note_parents(table, keys[:-1], line), keys[-1])
        self.lines[path] = line
        self._skip_blank()
        self.at += 1  # the equals sign
        self._skip_blank()
        self._value(path)

    def _value(self, path: Path) -> None:
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
        while self._next_item("]"):
            self.lines[(*path, index)] = self._line()
            self._value((*path, index))
            index += 1

    def _inline_table(self, path: Path) -> None:
        while self._next_item("}"):
            self._pair(path)

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

    def _line(self) -> int:
        return bisect_right(self.line_ends, self.at) + 1


def _unquoted(key: str) -> str:
    if key.startswith("'") or "\\" not in key:
        return key[1:-1]
    import tomllib  # late: keys with escapes are rare

    name: str = next(iter(tomllib.loads(f"{key} = 0")))
    return name
