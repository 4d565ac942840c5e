"""Workbooks (xlsx) as tables of cells, by the standard library alone.

Nothing of a workbook is ever computed: of a formula the number counts that stands beside it. Its parts are unzipped no
further than a limit, whatever their headers say, and a document type, with which entities come, is refused before the
XML is read. Libraries that read workbooks do neither.
"""

from __future__ import annotations

import io
import re
import zipfile
import zlib
from collections.abc import Iterator
from xml.etree import ElementTree

from tmmcalc.classroom.answers.grids import Grid, checked
from tmmcalc.classroom.answers.limits import CELLS, COLUMNS, PARTS, ROWS, TAGS, UNZIPPED, UnreadableError

FORMULA = "=formula without a value"  # what a cell reads whose number nobody has computed
DATE = "a date"  # what a spreadsheet makes of 5.11 where the decimal sign is a comma
_DATES = {*range(14, 23), *range(27, 37), *range(45, 48), *range(50, 59)}  # number formats that are dates
_CELL = re.compile(r"([A-Z]{1,3})(\d{1,7})")
_REMEDY = "save it anew as xlsx, or as CSV"


def sheets_of_workbook(content: bytes) -> list[Grid]:
    """The sheets of a workbook that hold something, in their order; raises `UnreadableError`."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as book:
            return _sheets(_Parts(book))
    except (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, EOFError, OSError):
        raise UnreadableError("is a damaged or locked workbook", _REMEDY) from None
    except (ElementTree.ParseError, UnicodeDecodeError, ValueError, KeyError, LookupError):
        raise UnreadableError("is no workbook that can be read", _REMEDY) from None


class _Parts:
    """The files within a workbook, of all together so many bytes at most."""

    def __init__(self, book: zipfile.ZipFile) -> None:
        self._book, self._left = book, UNZIPPED
        self.names = book.namelist()
        if len(self.names) > PARTS or sum(each.file_size for each in book.infolist()) > UNZIPPED:
            raise UnreadableError(f"is more than {UNZIPPED // 10**6} MB when unzipped", "hand in the table alone")

    def root(self, name: str) -> ElementTree.Element:
        """The XML of a part; what its header says of its size is not believed."""
        with self._book.open(name) as part:
            content = part.read(self._left + 1)
        self._left -= len(content)
        if self._left < 0 or content.count(b"<") > TAGS:
            raise UnreadableError(f"is more than {UNZIPPED // 10**6} MB when unzipped", "hand in the table alone")
        if re.search(rb"<\s*!\s*(DOCTYPE|ENTITY)", content.replace(b"\x00", b""), re.IGNORECASE):
            raise UnreadableError("defines entities, which no spreadsheet does", _REMEDY)
        return ElementTree.fromstring(content)


def _sheets(parts: _Parts) -> list[Grid]:
    if "xl/workbook.xml" not in parts.names:
        raise UnreadableError("is an archive, not a workbook", "hand in the files themselves")
    texts = _texts(parts)
    dates = _dates(parts)
    found = []
    left = CELLS
    for name in _in_order(parts):
        grid = _grid(parts.root(name), texts, dates, left)
        left -= sum(map(len, grid))
        if any(any(row) for row in grid):
            found.append(checked(grid))
    return found


def _in_order(parts: _Parts) -> list[str]:
    """The sheets that can be seen as they follow in the book; all that there are where it does not say."""
    targets = {}
    if "xl/_rels/workbook.xml.rels" in parts.names:
        for each in parts.root("xl/_rels/workbook.xml.rels"):
            target = each.get("Target", "").removeprefix("/")
            targets[each.get("Id")] = target if target.startswith("xl/") else f"xl/{target}"
    listed = []
    for sheet in _all(parts.root("xl/workbook.xml"), "sheet"):
        key = next((value for name, value in sheet.attrib.items() if _local(name) == "id"), None)
        if targets.get(key) in parts.names and sheet.get("state", "visible") == "visible":
            listed.append(targets[key])
    return listed or sorted(name for name in parts.names if re.fullmatch(r"xl/worksheets/[^/]+\.xml", name))


def _texts(parts: _Parts) -> list[str]:
    if "xl/sharedStrings.xml" not in parts.names:
        return []
    return [_text(each) for each in _all(parts.root("xl/sharedStrings.xml"), "si")]


def _dates(parts: _Parts) -> frozenset[str]:
    """Styles of cells that show a number as a date."""
    if "xl/styles.xml" not in parts.names:
        return frozenset()
    root = parts.root("xl/styles.xml")
    own = {
        each.get("numFmtId")
        for each in _all(root, "numFmt")
        if re.search(
            "[dmyhs]", re.sub(r'"[^"]*"|\[[^\]]*\]|\\.|General', "", each.get("formatCode", "")), re.IGNORECASE
        )
    }
    known = own | {str(number) for number in _DATES}
    styles = next(_all(root, "cellXfs"), ())
    return frozenset(str(k) for k, each in enumerate(styles) if each.get("numFmtId") in known)


def _grid(root: ElementTree.Element, texts: list[str], dates: frozenset[str], left: int) -> Grid:
    rows: dict[int, dict[int, str]] = {}
    at = count = 0
    for row in _all(root, "row"):
        at = int(row.get("r") or at + 1)
        column = 0
        for cell in (each for each in row if _local(each.tag) == "c"):
            place = _CELL.fullmatch(cell.get("r", ""))
            column = _column(place[1]) if place else column + 1
            value = _value(cell, texts, dates)
            if not value:
                continue
            if at > ROWS or column > COLUMNS or (count := count + 1) > left:
                raise UnreadableError(
                    f"has more than {ROWS} rows, {COLUMNS} columns or {CELLS} cells", "hand in the table alone"
                )
            rows.setdefault(at, {})[column] = value
    last = max(rows, default=0)
    return [_filled(rows.get(k, {})) for k in range(1, last + 1)]


def _filled(row: dict[int, str]) -> list[str]:
    return [row.get(k, "") for k in range(1, max(row, default=0) + 1)]


def _value(cell: ElementTree.Element, texts: list[str], dates: frozenset[str]) -> str:
    kind = cell.get("t", "n")
    children = {_local(each.tag): each for each in cell}
    value = (children["v"].text or "").strip() if "v" in children else ""
    if kind == "inlineStr":
        return _text(children["is"]).strip() if "is" in children else ""
    if "f" in children and not value:
        return FORMULA
    if kind == "s" and value:
        return texts[int(value)].strip()
    if kind == "n" and value:
        return DATE if cell.get("s", "") in dates else _plain(value)
    return value


def _plain(value: str) -> str:
    """A number as people see it: a binary 0.30000000000000004 is 0.3."""
    return f"{float(value):.12g}"


def _text(element: ElementTree.Element) -> str:
    """The runs of a text, without what is said of its pronunciation."""
    if _local(element.tag) == "rPh":
        return ""
    own = (element.text or "") if _local(element.tag) == "t" else ""
    return own + "".join(map(_text, element))


def _column(letters: str) -> int:
    number = 0
    for letter in letters:
        number = number * 26 + ord(letter) - 64
    return number


def _all(root: ElementTree.Element, name: str) -> Iterator[ElementTree.Element]:
    return (each for each in root.iter() if _local(each.tag) == name)


def _local(tag: str) -> str:
    return tag.rpartition("}")[2] if isinstance(tag, str) else ""
