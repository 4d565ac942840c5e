"""Tables of cells out of texts: any encoding, any delimiter."""

from __future__ import annotations

import csv
import io
import re
from collections import Counter

from tmmcalc.classroom.answers.limits import COLUMNS, ROWS, WIDEST, UnreadableError

Grid = list[list[str]]  # rows of cells without blanks around them

_DELIMITERS = ("\t", ";", "|")
_PAIR = re.compile(r"(?P<name>[^=:]+?)\s*[=:]\s*(?P<value>.+)")


def text_of(content: bytes) -> str:
    """The text of a file: UTF-8, UTF-16 with a byte order mark or without, else cp1251.

    Raises `UnreadableError` for what is no text.
    """
    if not content.strip(b"\x00\t\r\n \xef\xbb\xbf\xff\xfe"):
        raise UnreadableError("is empty")
    for mark, encoding in ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16")):
        if content.startswith(mark):
            return _checked(content, encoding)
    if b"\x00" in content:
        odd, even = content[1::2].count(0), content[::2].count(0)
        return _checked(content, "utf-16-le" if odd >= even else "utf-16-be")
    try:
        return _checked(content, "utf-8")
    except UnreadableError:
        return _checked(content, "cp1251")


def _checked(content: bytes, encoding: str) -> str:
    try:
        text = content.decode(encoding)
    except UnicodeDecodeError:
        raise UnreadableError("is no text that can be read", "save it as CSV in UTF-8") from None
    if re.search(r"[\x00-\x08\x0e-\x1f]", text):
        raise UnreadableError("holds bytes that are no text", "save it as CSV in UTF-8")
    return text


def grid_of(text: str) -> Grid:
    """The rows of a CSV text; raises `UnreadableError` where it is none, or too large.

    Tabs, semicolons and bars part cells before commas do, since a comma may be decimal. Lines without any of them may
    be ``name = value``.
    """
    lines = text.splitlines()
    if len(lines) > ROWS:
        raise UnreadableError(f"has {len(lines)} lines, more than {ROWS}", "hand in the table alone")
    filled = [line for line in lines if line.strip()]
    if not filled:
        raise UnreadableError("is empty")
    if (named := re.fullmatch(r"\s*sep=([,;|\t])\s*", filled[0])) is not None:  # what a spreadsheet puts there
        return _parted("\n".join(filled[1:]), named[1])
    delimiter = _delimiter(filled)
    if delimiter is None:
        pairs = (_PAIR.fullmatch(line.strip()) for line in filled)
        return checked([[pair["name"], pair["value"].strip()] if pair else [] for pair in pairs])
    return _parted(text, delimiter)


def _parted(text: str, delimiter: str) -> Grid:
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))
    except csv.Error as error:
        raise UnreadableError(f"is no CSV: {error}", "save it as CSV anew") from None
    return checked([[cell.strip() for cell in row] for row in rows])


def checked(grid: Grid) -> Grid:
    """The grid itself; raises `UnreadableError` where it is larger than a table of answers can be."""
    if len(grid) > ROWS:
        raise UnreadableError(f"has more than {ROWS} rows", "hand in the table alone")
    if max(map(len, grid), default=0) > COLUMNS:
        raise UnreadableError(f"has more than {COLUMNS} columns", "hand in the table alone")
    if any(len(cell) > WIDEST for row in grid for cell in row):
        raise UnreadableError(f"has a cell of more than {WIDEST} characters", "write one number into a cell")
    return grid


def _delimiter(lines: list[str]) -> str | None:
    """What parts the cells of most lines; None: nothing does."""
    bare = [re.sub(r'"[^"]*"', "", line) for line in lines[:200]]
    has = Counter({sign: sum(sign in line for line in bare) for sign in _DELIMITERS})
    sign, count = has.most_common(1)[0]
    if count * 2 >= len(bare):
        return sign
    if sum("," in line for line in bare) * 2 < len(bare):
        return None
    # a comma in `H = 1,25` is decimal
    return None if all(_PAIR.fullmatch(line.strip()) for line in bare) else ","
