"""What stands in a table of answers: who, which item, the text of the value and of the unit, wherever they stand.

A table is one of these, told by the names in it:

- wide: a header of items, a row a student, or one row of the student of the file; units in the header, or in a row of
  their own under it;
- turned: a column of items, a column a student;
- long: columns of item and value, and of student and unit where there are such;
- pairs: rows of item, value and unit without a header, among them one of the student or the variant;
- over positions: a column of positions, by number or by angle, and columns of results.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from tmmcalc.classroom.answers.figures import NoNumberError, read_number
from tmmcalc.classroom.answers.grids import Grid
from tmmcalc.classroom.answers.limits import UnreadableError
from tmmcalc.classroom.answers.measures import UnitOfAnswerError, factor_to, is_none, is_unit
from tmmcalc.classroom.answers.naming import Names, Place, Roster, folded, parted
from tmmcalc.classroom.answers.positions import Rows, Steps
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record

STUDENT = ("student", "name", "variant", "студент", "студентка", "прізвище", "піб", "варіант", "учень", "№ варіанта")
_ITEM = ("item", "quantity", "result", "величина", "результат", "позначення", "параметр", "symbol")
_NAME = ("name", "назва", "найменування")  # of an item, where none of these is there; "name" may be the student's too
_VALUE = ("value", "answer", "значення", "відповідь")
_UNITS = (
    "unit",
    "units",
    "одиниця",
    "одиниці",
    "од",
    "од. вим.",
    "од. виміру",
    "од. вимірювання",
    "одиниця виміру",
    "одиниці виміру",
    "одиниця вимірювання",
    "одиниці вимірювання",
    "розмірність",
)
_POSITION = ("position", "положення", "номер положення", "№ положення", "пол.", "i", "n", "no", "№")
_ANGLE = ("phi", "φ", "φ1", "phi_1", "phi1", "angle", "кут", "кут повороту", "кут φ", "кут повороту кривошипа")


@record
class Entry:
    """The text of an answer where it stands."""

    student: str  # as written; empty: of the file
    item: int
    value: str
    unit: str
    where: str  # "row 5", to be said in another language


def _row(number: int) -> Phrase:
    """Where a row is, from 1."""
    return Phrase("row {number}", number=number)


@record
class Lost:
    """A column over positions of which no row, or more than one, is that of its item by what all variants share."""

    item: int
    what: Phrase  # was sought
    rows: Rows
    entries: tuple[Entry, ...]  # of each row

    def at(self, angle: float) -> Entry | None:
        """What stands at the angle [deg] that the position has in a variant."""
        k = self.rows.at(angle)
        return None if k is None else self.entries[k]


@record
class Table:
    """What a table tells."""

    entries: tuple[Entry, ...]
    student: str = ""  # of the whole table, as written in it
    unknown: tuple[str, ...] = ()  # names of no item
    unused: tuple[str, ...] = ()  # heads of columns of which nothing is read
    lost: tuple[Lost, ...] = ()


def entries_of(grid: Grid, names: Names, roster: Roster, steps: Steps) -> Table:
    """What stands in a table; ``steps`` tell where the positions of the mechanism are.

    Raises `UnreadableError` where no item is named in it.
    """
    rows = [(k, row) for k, row in enumerate(grid, 1) if any(row)]
    for at, (_, header) in enumerate(rows):
        if _find(header, _VALUE) is not None and (item := _items_under(rows[at:], names)) is not None:
            return _of_long(rows[at:], names, item)
    best, count = _best_header(rows, names)
    over = _over_positions(rows, names)
    if over is not None and over[1] >= count:
        return _of_positions(rows[over[0] :], rows[: over[0]], names, steps)
    in_first = sum(names.headed(row[0])[0] is not None for _, row in rows)
    if in_first > count or (in_first == count == 1 and _is_value(rows[best], names)):
        return _of_items_below(rows, names, roster)
    if count:
        return _of_wide(rows[best:], rows[:best], names, roster)
    raise UnreadableError("names no result that is asked", "write the names of the results as in the task")


Row = tuple[int, list[str]]


def _is(cell: str, words: Sequence[str]) -> bool:
    return _bare(parted(cell)[0]) in {_bare(word) for word in words}


def _bare(text: str) -> str:
    """A word of a header as it is compared, without the signs about it."""
    return re.sub(r"[.:()\[\]]", "", folded(text))


def _find(row: Sequence[str], words: Sequence[str]) -> int | None:
    return next((k for k, cell in enumerate(row) if cell and _is(cell, words)), None)


def _cell(row: Sequence[str], k: int | None) -> str:
    return row[k] if k is not None and k < len(row) else ""


def _items_under(rows: Sequence[Row], names: Names) -> int | None:
    """The column of items under this header."""
    header = rows[0][1]
    if (named := _find(header, _ITEM)) is not None:
        return named
    called = _find(header, _NAME)
    is_item = called is not None and any(names.headed(_cell(row, called))[0] is not None for _, row in rows[1:])
    return called if is_item else None


def _of_long(rows: Sequence[Row], names: Names, item: int) -> Table:
    header = rows[0][1]
    student, value, unit = (_find(header, words) for words in (STUDENT, _VALUE, _UNITS))
    if student == item:
        student = None
    known = {student, value, item, unit}
    others = [k for k in range(max(len(row) for _, row in rows)) if k not in known and any(_below(rows, k))]
    if unit is None and (unit := next((k for k in others if _are_units(_below(rows, k))), None)) is not None:
        others.remove(unit)
    unused = tuple(head for k in others if (head := _cell(header, k)) and not _is(head, _POSITION))
    head_unit = parted(header[value])[1] if value is not None else ""
    found, unknown, last = [], [], ""
    for number, row in rows[1:]:
        last = _cell(row, student) or last  # a name over its rows stands once
        name = _cell(row, item)
        k, name_unit = names.headed(name)
        if k is None:
            unknown += [name] * bool(name)
        else:
            of_row = _cell(row, unit) or name_unit or (head_unit if names.has_unit(k, head_unit) else "")
            found.append(Entry(last, k, _cell(row, value), of_row, _row(number)))
    return Table(tuple(found), unknown=tuple(unknown), unused=unused)


def _below(rows: Sequence[Row], k: int) -> list[str]:
    """What stands under the header in a column."""
    return [cell for _, row in rows[1:] if (cell := _cell(row, k))]


def _are_units(cells: Sequence[str]) -> bool:
    """Whether most are units, and one does not say that there is none."""
    return 2 * sum(map(is_unit, cells)) > len(cells) and any(is_unit(cell) and not is_none(cell) for cell in cells)


def _best_header(rows: Sequence[Row], names: Names) -> tuple[int, int]:
    """The row with the most names of items, and how many it has."""
    counts = [sum(names.headed(cell)[0] is not None for cell in row if cell) for _, row in rows[:50]]
    count = max(counts, default=0)
    return (counts.index(count), count) if count else (0, 0)


def _of_wide(rows: Sequence[Row], above: Sequence[Row], names: Names, roster: Roster) -> Table:
    header = rows[0][1]
    columns = {k: names.headed(cell) for k, cell in enumerate(header) if cell}
    items = {k: (item, unit) for k, (item, unit) in columns.items() if item is not None}
    who = _find(header, STUDENT)
    if who is None:  # a column whose cells name students, whatever stands over it
        who = next((k for k in range(min(items)) if any(roster.student(_cell(row, k)) for _, row in rows[1:])), None)
    below = list(rows[1:])
    units = dict[int, str]()
    if below and all(not _cell(below[0][1], k) or is_unit(_cell(below[0][1], k)) for k in items):
        units = {k: _cell(below[0][1], k) for k in items}
        below.pop(0)
    if who is None and len(below) > 1 and sum(any(_cell(row, k) for k in items) for _, row in below) > 1:
        raise UnreadableError("has several rows and no column of students", 'head it "student" or "variant"')
    found = [
        Entry(_cell(row, who), item, _cell(row, k), unit or units.get(k, ""), _row(number))
        for number, row in below
        for k, (item, unit) in items.items()
        if _cell(row, k) or (who is not None and _cell(row, who))
    ]
    ignored = {who, _find(header, STUDENT)}
    unknown = tuple(
        header[k] for k, (item, _) in columns.items() if item is None and k not in ignored and k > min(items)
    )
    return Table(tuple(found), _said(above), unknown)


def _said(rows: Sequence[Row]) -> str:
    """The student that a row beside the table names: "student; Bondar", or "variant 5" in one cell."""
    for _, row in rows:
        filled = [cell for cell in row if cell]
        if len(filled) >= 2 and _is(filled[0], STUDENT):
            return filled[1]
        if (
            filled
            and (match := re.fullmatch(r"\s*(\S+(?: \S+)?)\s*[:№ ]\s*(\S.*)", filled[0]))
            and _is(match[1], STUDENT)
        ):
            return match[2]
    return ""


def _is_value(row: Row, names: Names) -> bool:
    """Whether a row is an item and its number."""
    filled = [cell for cell in row[1] if cell]
    return len(filled) > 1 and names.headed(filled[0])[0] is not None and _number(filled[1])


def _number(cell: str) -> bool:
    try:
        read_number(cell)
    except NoNumberError:
        return False
    return True


def _of_items_below(rows: Sequence[Row], names: Names, roster: Roster) -> Table:
    """A column of items: pairs of item and value, or a column a student where a row above names several."""
    first = next(k for k, (_, row) in enumerate(rows) if names.headed(row[0])[0] is not None)
    header = next((row for _, row in reversed(rows[:first]) if len(_students(row, roster)) > 1), None)
    students = _students(header, roster) if header else {1: ""}
    unit_column = _find(header, _UNITS) if header else _find(rows[first - 1][1], _UNITS) if first else None
    if unit_column is None and not header:
        unit_column = 2
    found, unknown = [], []
    for number, row in rows[first:]:
        k, unit = names.headed(row[0])
        if k is None:
            if row[0] and not _is(row[0], STUDENT):
                unknown.append(row[0])
            continue
        beside = _cell(row, unit_column)
        for column, student in students.items():
            if (text := _cell(row, column)) or student:
                found.append(Entry(student, k, text, unit or beside, _row(number)))
    return Table(tuple(found), _said(rows) if not header else "", tuple(unknown))


def _students(row: Sequence[str], roster: Roster) -> dict[int, str]:
    return {k: cell for k, cell in enumerate(row) if k and cell and roster.student(cell) is not None}


def _over_positions(rows: Sequence[Row], names: Names) -> tuple[int, int] | None:
    """The header of a table over positions, and how many of its columns are asked for somewhere."""
    for at, (_, row) in enumerate(rows[:50]):
        count = sum(bool(names.column(cell)[0]) for cell in row if cell)
        if count and (_find(row, _POSITION) is not None or _find(row, _ANGLE) is not None):
            return at, count
    return None


def _of_positions(rows: Sequence[Row], above: Sequence[Row], names: Names, steps: Steps) -> Table:
    header = rows[0][1]
    label, angle = _find(header, _POSITION), _find(header, _ANGLE)
    of_angle = parted(_cell(header, angle))[1] if angle is not None else ""
    below = [row for row in rows[1:] if not all(not cell or is_unit(cell) for cell in row[1])]
    units = next((row[1] for row in rows[1:2] if row not in below), [])
    table = Rows(
        tuple(_cell(row, label) for _, row in below),
        tuple(_angle(_cell(row, angle), of_angle or _cell(units, angle)) for _, row in below),
    )
    found, lost = [], []
    for k, cell in enumerate(header):
        places, of_header = names.column(cell) if cell else (frozenset[Place](), "")
        for place in sorted(places, key=lambda each: each.item):
            unit = of_header or _cell(units, k)
            entries = tuple(Entry("", place.item, _cell(row, k), unit, _row(number)) for number, row in below)
            there = table.of(place, steps)
            if len(there) == 1:
                found.append(entries[there[0]])
            else:
                what = "two rows may be that of {place}" if there else "no row is that of {place}"
                lost.append(Lost(place.item, Phrase(what, place=table.told(place, steps)), table, entries))
    return Table(tuple(found), _said(above), lost=tuple(lost))


def _angle(text: str, unit: str) -> float:
    """An angle in degrees, without a unit in degrees too; NaN where there is none."""
    try:
        written = read_number(text)
        factor = factor_to(written.unit or unit or "deg", "deg")
    except (NoNumberError, UnitOfAnswerError):
        return math.nan
    return float(written.value) * factor
