"""What has become of answers, as it is printed: for a student without a number of the key, for the teacher all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tmmcalc.classroom.marksheets import hints_of
from tmmcalc.classroom.papers.tasksheet import said_in
from tmmcalc.classroom.wording import cell_of, header_of, standing_said, title_of
from tmmcalc.core.printable import printable
from tmmcalc.note.assembled import Assembler
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Chapter, Listing, Paragraph, Table
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.classroom.marking import Marked, Marks
    from tmmcalc.note.tree import Written
    from tmmcalc.report.worksheets import Worksheet

LONGEST = 300  # characters of a cell
ACROSS, KEPT = 10, 2  # columns of a table; those at its left that stand in each part of a wider one


def student_results(marks: Marks, each: Marked, who: str) -> list[Written]:
    """The sheet of a student, in the language in force."""
    title = tr("Results: {who}", who=_said(who))
    return Assembler().written([Chapter("results", title, tuple(_of_student(marks, each)), number="")])


def _of_student(marks: Marks, each: Marked) -> Iterator[Block]:
    yield Paragraph(tr("Points: {points} of {most}.", points=number(each.total), most=number(marks.most)))
    head = (tr("Name"), tr("Unit"), tr("Answer"), tr("It is"), tr("Points for it"))
    rows = tuple(
        (
            *(_said(item.name), tr_unit(item.unit) or "–", _said(answer.text) or "–", standing_said(standing)),
            tr("{points} of {most}", points=number(got), most=number(item.weight)),
        )
        for item, answer, standing, got in zip(marks.items, each.answers, each.standings, each.points, strict=True)
    )
    yield Table(tr("Answers"), head, rows, "results")
    if hints := tuple(map(_said, hints_of(marks.items, marks.mistakes, each))):
        yield Paragraph(tr("Where to look:"))
        yield Listing(hints)


def teacher_results(tables: Sequence[Worksheet], title: str) -> list[Written]:
    """All that is known, a table of each kind, in the language in force."""
    return Assembler().written([Chapter("marks", title, tuple(_of_teacher(tables)), number="")])


def _of_teacher(tables: Sequence[Worksheet]) -> Iterator[Block]:
    for sheet in tables:
        name = title_of(sheet.name)
        if not sheet.rows:
            yield Paragraph(tr("{table}: none.", table=name))
            continue
        rows = [*zip(*sheet.columns, strict=True)]
        for columns in _parts(len(sheet.headers)):
            head = tuple(_said(header_of(sheet.headers[k], sheet.name)) for k in columns)
            cells = tuple(tuple(_said(cell_of(row[k], sheet.headers[k])) for k in columns) for row in rows)
            yield Table(name, head, cells)


def _parts(count: int) -> Iterator[Sequence[int]]:
    """The columns of each table into which a wide one is parted."""
    if count <= ACROSS + KEPT:
        yield range(count)
        return
    for at in range(KEPT, count, ACROSS):
        yield (*range(KEPT), *range(at, min(at + ACROSS, count)))


def _said(text: str) -> str:
    """What somebody has written, on one line, no longer than a cell has room for."""
    shown = said_in(" ".join(printable(text).split()))
    return shown if len(shown) <= LONGEST else f"{shown[:LONGEST]}…"
