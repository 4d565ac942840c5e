"""Files and folders of answers: each file is read or refused with one message, and the rest goes on.

Of two files of a student the later counts: the one in the later folder, by the date or the number in its name, and in
one folder the one that was written later.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from tmmcalc.classroom.answers.grids import Grid, grid_of, text_of
from tmmcalc.classroom.answers.handed import HandIn, Pile, Refused, hand_in
from tmmcalc.classroom.answers.layouts import Entry, Table, entries_of
from tmmcalc.classroom.answers.limits import BYTES, DEEPEST, FILES, UnreadableError
from tmmcalc.classroom.answers.naming import DATE, Names, Roster
from tmmcalc.classroom.answers.pairs import entries_of_toml
from tmmcalc.classroom.answers.positions import UNKNOWN, Steps
from tmmcalc.classroom.answers.workbooks import sheets_of_workbook
from tmmcalc.classroom.model import Item, Key
from tmmcalc.core.files import NoFileError, read_file
from tmmcalc.core.notes import Phrase
from tmmcalc.core.printable import printable
from tmmcalc.core.records import record
from tmmcalc.spec.phrases import show

UNFORESEEN = "is like nothing that was foreseen"
SHOWN = 5  # names that a message lists
_ZIP = b"PK\x03\x04"
_KINDS = (
    (b"%PDF", "is a PDF"),
    (b"\x89PNG", "is a picture"),
    (b"\xff\xd8\xff", "is a picture"),
    (b"GIF8", "is a picture"),
    (b"RIFF", "is a picture or a film"),
    (b"\xd0\xcf\x11\xe0", "is a workbook of an old kind (xls), or locked"),
    (b"Rar!", "is an archive"),
    (b"7z\xbc\xaf", "is an archive"),
    (b"\x1f\x8b", "is an archive"),
    (b"\x7fELF", "is a program"),
    (b"MZ\x90", "is a program"),
    (b"{\\rtf", "is a text document"),
)
_REMEDY = "hand in a table as CSV, xlsx or TOML"
_UNSEEN = ("__macosx", "thumbs.db", "desktop.ini")


AngleOf = Callable[[int, int], float]  # of the position of an item in a variant [deg]; NaN: not known


def nowhere(number: int, item: int) -> float:
    """The angle of a position of which nothing is known."""
    return math.nan


@record
class _File:
    path: Path
    source: str  # its path within the folder of answers
    order: tuple[tuple[int, ...], float, str]


def read_answers(
    place: Path, items: Sequence[Item], keys: Sequence[Key], steps: Steps = UNKNOWN, angle_of: AngleOf = nowhere
) -> Pile:
    """What stands in a file, or in all files of a folder.

    ``steps`` tell where the positions are, by which a table over angles is read; where they differ by variant,
    ``angle_of(number, item)`` does [deg], NaN: not known.
    """
    names, roster = Names(items), Roster(keys)
    hand_ins, refused, empty = list[HandIn](), list[Refused](), list[str]()
    for each in _files(place):
        if isinstance(each, Refused):
            refused.append(each)
            continue
        try:
            tables = tables_of(each.path, names, roster, steps)
            found, faults = _by_student(each.source, tables, items, roster, angle_of)
        except UnreadableError as fault:
            refused.append(Refused(each.source, fault.message, fault.remedy))
            continue
        except Exception as error:  # one file that breaks the program must not end the others
            refused.append(Refused(each.source, f"{UNFORESEEN} ({type(error).__name__})", _REMEDY))
            continue
        answered = [each for each in found if any(answer.text for answer in each.answers)]
        if not answered and not faults:
            empty.append(each.source)
        hand_ins += answered
        refused += faults
    return Pile(tuple(hand_ins), tuple(refused), tuple(empty))


def read_own(file: Path, items: Sequence[Item], steps: Steps = UNKNOWN, angle_of: AngleOf = nowhere) -> HandIn:
    """The answers of the one student whose file it is; raises `UnreadableError`."""
    tables = tables_of(file, Names(items), Roster(()), steps)
    entries = _entries(tables, 1, angle_of)
    students = list(dict.fromkeys(entry.student for entry in entries if entry.student))
    if len(students) > 1:
        some = ", ".join(map(show, students[:SHOWN]))
        raise UnreadableError(f"tells of {len(students)} students: {some}", "leave your own answers alone in it")
    return _with_strange(hand_in(1, _one_line(file.name), entries, items), tables, items)


def tables_of(file: Path, names: Names, roster: Roster, steps: Steps) -> list[Table]:
    """What the tables of a file tell; raises `UnreadableError` where none tells anything."""
    content = _content(file)
    if content.startswith(_ZIP):
        grids = sheets_of_workbook(content)
        if not grids:
            raise UnreadableError("is an empty workbook", _REMEDY)
        return _of_sheets(grids, names, roster, steps)
    kind = next((kind for start, kind in _KINDS if content.startswith(start)), None)
    if kind is not None:
        raise UnreadableError(kind, _REMEDY)
    text = text_of(content)
    if file.suffix.lower() == ".toml":
        return [entries_of_toml(text, names, roster)]
    return [entries_of(grid_of(text), names, roster, steps)]


def _of_sheets(grids: Sequence[Grid], names: Names, roster: Roster, steps: Steps) -> list[Table]:
    """The sheets that name results; raises the fault of the first where none does."""
    found, faults = list[Table](), list[UnreadableError]()
    for grid in grids:
        try:
            found.append(entries_of(grid, names, roster, steps))
        except UnreadableError as fault:
            faults.append(fault)
    if not found:
        raise faults[0]
    return found


def _content(file: Path) -> bytes:
    try:
        content = read_file(file, BYTES)
    except NoFileError as error:
        raise UnreadableError(f"is {error.kind}, not a file", _REMEDY) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "it cannot be opened"
        raise UnreadableError(f"cannot be read: {reason}") from None
    if len(content) > BYTES:
        raise UnreadableError(f"is larger than {BYTES // 10**6} MB", "hand in the table alone")
    return content


def _files(place: Path) -> Iterator[_File | Refused]:
    """The files of a place in the order of time, and what is there besides."""
    if not place.is_dir():
        yield _File(place, _one_line(place.name), ((), 0.0, place.name))
        return
    found, others = list[_File](), list[Refused]()
    for each in _within(place, (), others):
        if len(found) == FILES:
            others.append(Refused(each.source, f"is one of more than {FILES} files; it and all after it are left out"))
            break
        found.append(each)
    yield from others
    yield from sorted(found, key=lambda each: each.order)


def _within(folder: Path, above: tuple[str, ...], others: list[Refused]) -> Iterator[_File]:
    try:
        entries = sorted(os.scandir(folder), key=lambda each: each.name)
    except OSError as error:
        others.append(Refused("/".join(above) or folder.name, f"cannot be read: {error.strerror}"))
        return
    for each in entries:
        parts = (*above, each.name)
        source = _one_line("/".join(parts))
        if each.name.startswith((".", "~$")) or each.name.casefold() in _UNSEEN:
            continue
        if each.is_symlink():
            others.append(Refused(source, "is a link, which is not followed", "put the file itself there"))
        elif each.is_dir(follow_symlinks=False):
            if len(parts) > DEEPEST:
                others.append(Refused(source, f"is a folder more than {DEEPEST} deep", "put its files further up"))
            else:
                yield from _within(Path(each.path), parts, others)
        else:
            time = each.stat(follow_symlinks=False).st_mtime
            yield _File(Path(each.path), source, (tuple(n for part in above for n in _turn(part)), time, source))


def _one_line(name: str) -> str:
    """The name of a file as messages and tables show it."""
    return printable(name).replace("\n", "\\n")


def _turn(folder: str) -> tuple[int, ...]:
    """What a folder says of the time: its date, or the number that it is; nothing where it says neither.

    >>> _turn("2026-05-12"), _turn("12.05.2026"), _turn("2 again"), _turn("Bondar_123_file")
    ((2026, 5, 12), (2026, 5, 12), (2,), ())
    """
    if match := DATE.search(folder):
        year, month, day, *_ = match.groups() if match[1] else reversed(match.groups())
        return int(year), int(month), int(day)
    numbered = re.match(r"\d{1,4}(?!\d)", folder)
    return (int(numbered[0]),) if numbered else ()


def _by_student(
    source: str, tables: Sequence[Table], items: Sequence[Item], roster: Roster, angle_of: AngleOf
) -> tuple[list[HandIn], list[Refused]]:
    """The answers of a file by student; raises `UnreadableError` where it says nowhere whose it is."""
    lost = [each for table in tables for each in table.lost]
    if not lost and not any(table.entries for table in tables):
        raise UnreadableError("names results, and no answer to them", "write each answer beside or under its name")
    unnamed = any(not entry.student for table in tables for entry in table.entries)
    own = _owner(source, tables, roster) if lost or unnamed else None
    entries = _entries(tables, own, angle_of)
    if not entries:
        told = [f"{items[each.item].name}: {each.what}" for each in lost]
        more = f"; and {len(told) - SHOWN} more" if len(told) > SHOWN else ""
        message = f"names results over positions, and answers none: {'; '.join(told[:SHOWN])}{more}"
        raise UnreadableError(message, "write the number of each position in a column position")
    unknown = dict[str, str]()
    found = dict[int, list[Entry]]()
    for entry in entries:
        number = roster.student(entry.student) if entry.student else own
        if number is None:
            unknown.setdefault(entry.student, entry.where)
        else:
            found.setdefault(number, []).append(entry)
    faults = []
    if unknown:
        some = ", ".join(f"{show(name)} ({where})" for name, where in list(unknown.items())[:SHOWN])
        more = f" and {len(unknown) - SHOWN} more" if len(unknown) > SHOWN else ""
        faults.append(
            Refused(source, f"names nobody of the roster, or several: {some}{more}", "write the number of the variant")
        )
    made = [hand_in(number, source, entries, items) for number, entries in found.items()]
    return [_with_strange(made[0], tables, items)] if len(made) == 1 else made, faults


def _entries(tables: Sequence[Table], own: int | None, angle_of: AngleOf) -> list[Entry]:
    """All answers of tables; those over angles too that only the variant of their student tells."""
    found = [entry for table in tables for entry in table.entries]
    there = (each.at(angle_of(own, each.item)) for table in tables for each in table.lost if own is not None)
    return [*found, *(entry for entry in there if entry is not None)]


def _with_strange(found: HandIn, tables: Sequence[Table], items: Sequence[Item]) -> HandIn:
    """A hand-in with remarks on what its tables tell that is not read."""
    unknown = [name for table in tables for name in table.unknown]
    unused = [head for table in tables for head in table.unused]
    lost = {each.item: each.what for table in tables for each in table.lost if not found.answers[each.item].text}
    told = [Phrase("{item}: {what}", item=items[k].name, what=what) for k, what in lost.items()]
    if unknown:
        told.append(_listed("not asked: {names}", "not asked: {names} and {count} more", unknown))
    if unused:
        whole = "columns of which nothing is read: {names}"
        told.append(_listed(whole, "columns of which nothing is read: {names} and {count} more", unused))
    return replace(found, remarks=(*found.remarks, *told))


def _listed(whole: str, cut: str, names: Sequence[str]) -> Phrase:
    """A remark with all names, or with the first of many and how many more there are."""
    shown = tuple(map(show, names[:SHOWN]))
    more = len(names) - SHOWN
    return Phrase(cut, names=shown, count=more) if more > 0 else Phrase(whole, names=shown)


def _owner(source: str, tables: Sequence[Table], roster: Roster) -> int:
    """Whose file it is, by its name and by what stands in it, which must not gainsay each other."""
    *folders, name = source.split("/")
    by_name = roster.of_file([*folders, name.rpartition(".")[0] or name])
    said = {table.student for table in tables if table.student}
    inside = {number for text in said if (number := roster.student(text)) is not None}
    if len(inside) > 1 or (inside and by_name is not None and by_name not in inside):
        told = ", ".join(map(show, sorted(said)))
        raise UnreadableError(f"is named after another student than stands in it: {told}", "rename it, or mend the row")
    if inside:
        return inside.pop()
    if by_name is None:
        raise UnreadableError(
            "does not say whose it is", "name it by the number of the variant or the student, or add a row student"
        )
    return by_name
