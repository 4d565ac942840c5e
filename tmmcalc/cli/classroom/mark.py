"""``tmmcalc class mark``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Quiet, available
from tmmcalc.cli.output import check_apart, check_place, show
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind

if TYPE_CHECKING:
    from tmmcalc.classroom.marking import Marks
    from tmmcalc.report.worksheets import Worksheet

FORMS = (".csv", ".xlsx", ".md")


def command(
    place: Annotated[
        Path, typer.Argument(metavar="CLASS", help="Folder of the class, or its assignment.", show_default=False)
    ],
    answers: Annotated[
        Path, typer.Argument(metavar="ANSWERS", help="Folder of what was handed in, or one file.", show_default=False)
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            "-o", "--out", metavar="FILE", help="Marks by student: csv, xlsx or md by its suffix.", show_default=False
        ),
    ] = None,
    full: Annotated[
        Path | None,
        typer.Option(
            "--full",
            metavar="FILE",
            help="All for the teacher, with the key: xlsx or md; of csv the answers alone.",
            show_default=False,
        ),
    ] = None,
    sheets: Annotated[
        Path | None,
        typer.Option(
            "--sheets",
            metavar="DIR",
            help="A sheet for each student, without a number of the key.",
            show_default=False,
        ),
    ] = None,
    keys: Annotated[
        Path | None,
        typer.Option(
            "--keys", metavar="DIR", help="Folder of the keys (default: keys, there or here).", show_default=False
        ),
    ] = None,
    form: Form = Format.table,
    quiet: Quiet = False,
) -> None:
    """Mark what students have handed in: right, right by plans, carried on, wrong, missing; and why it is wrong.

    Answers are CSV, xlsx or TOML, a file a student or one for all, with any units and either decimal sign. A file that
    cannot be read costs one warning, the others are marked. Of two hand-ins of a student the one in the later folder
    counts, by the date or the number of its name, else the later file; both stand in --full. Tolerances and weights are
    those that the assignment has now, so that marks can be made again.

    Example: tmmcalc class mark class answers -o marks.csv --full marks.xlsx
    """
    for file, flag in ((out, "-o"), (full, "--full")):
        if file is not None:
            _check(file, flag)
    check_apart(out, full, sheets, where="-o, --full, --sheets")
    if sheets is not None and (sheets.is_file() or other_kind(sheets) not in ("", "a folder")):
        raise UsageError(f"{sheets} is no folder", where="--sheets", remedy="name a folder, which is made")
    from tmmcalc.classroom.grading import graded
    from tmmcalc.classroom.marksdocument import marks_document
    from tmmcalc.classroom.marksheets import grades, teachers
    from tmmcalc.classroom.statistics import statistics_of

    marks, book = graded(place, answers, keys)
    for refused in marks.refused:
        warn(f"{refused.source} {refused.message}" + (f"\n  -> {refused.remedy}" if refused.remedy else ""))
    statistics = statistics_of(marks)
    if out is not None:
        _write(out, [grades(marks)], "marks")
    if full is not None:
        tables = teachers(marks, book, statistics)
        _write(full, tables[1:2] if full.suffix.lower() == ".csv" else tables, "marks, with the key")
    if sheets is not None:
        _write_sheets(sheets, marks)
    show(marks_document(marks, statistics), form)
    if not quiet:
        note_written(*(file for file in (out, full) if file is not None))
        if sheets is not None:
            note_written(sheets)


def _check(file: Path, flag: str) -> None:
    check_place(file, flag)
    if file.suffix.lower() not in FORMS:
        raise UsageError(f"{file} is no table of marks", where=flag, remedy=f"end its name in {', '.join(FORMS)}")
    if file.suffix.lower() == ".xlsx":
        available(Format.xlsx)


def _write(file: Path, tables: Sequence[Worksheet], title: str) -> None:
    from tmmcalc.classroom.marksheets import as_csv, as_markdown
    from tmmcalc.core.atomic import replace_file
    from tmmcalc.report.workbook import workbook

    suffix = file.suffix.lower()
    if suffix == ".xlsx":
        replace_file(file, workbook(tables, title))
    elif suffix == ".md":
        replace_file(file, as_markdown(tables, title).encode())
    else:
        replace_file(file, as_csv(tables[0]).encode("utf-8-sig"))  # as spreadsheets need it


def _write_sheets(folder: Path, marks: Marks) -> None:
    from tmmcalc.classroom.marksheets import students_sheet
    from tmmcalc.classroom.roster import stem
    from tmmcalc.core.atomic import blamed_on, replace_file

    with blamed_on(folder, "made"):
        folder.mkdir(parents=True, exist_ok=True)
    for each in marks.counting:
        replace_file(folder / f"{stem(each.number, each.student)}.md", students_sheet(marks, each).encode())
