"""``tmmcalc class mark``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Language, Quiet, available, spoken_in
from tmmcalc.cli.output import check_apart, check_place, show
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind
from tmmcalc.report.language import speaking, tr

if TYPE_CHECKING:
    from tmmcalc.classroom.marking import Marked, Marks
    from tmmcalc.classroom.model import Keybook
    from tmmcalc.classroom.statistics import Statistics
    from tmmcalc.report.worksheets import Worksheet

TABLES = (".csv", ".xlsx", ".md")
PRINTED = (".pdf", ".docx", ".html", ".typ", ".txt")


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
            help="All for the teacher, with the key: xlsx, md, pdf, docx, html; of csv the answers alone.",
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
    sheet_form: Annotated[
        str,
        typer.Option("--sheet-form", metavar="FORM", help="Form of these sheets: md, pdf, docx, html, typ or txt."),
    ] = "md",
    gradebook: Annotated[
        Path | None,
        typer.Option(
            "--gradebook",
            metavar="FILE",
            help="Who, grade and feedback, as grade books of courses take it: csv or xlsx.",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
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
    _check(out, "-o", TABLES)
    _check(full, "--full", (*TABLES, *PRINTED))
    _check(gradebook, "--gradebook", TABLES[:2])
    check_apart(out, full, gradebook, sheets, where="-o, --full, --gradebook, --sheets")
    if sheets is not None:
        if sheets.is_file() or other_kind(sheets) not in ("", "a folder"):
            raise UsageError(f"{sheets} is no folder", where="--sheets", remedy="name a folder, which is made")
        if sheet_form != "md":
            from tmmcalc.note.forms import check_form

            check_form(sheet_form, "a sheet", "--sheet-form")
    from tmmcalc.classroom.grading import graded
    from tmmcalc.classroom.marksdocument import marks_document
    from tmmcalc.classroom.marksheets import grades
    from tmmcalc.classroom.statistics import statistics_of

    marks, book, scene = graded(place, answers, keys)
    for refused in marks.refused:
        warn(f"{refused.source} {refused.message}" + (f"\n  -> {refused.remedy}" if refused.remedy else ""))
    statistics = statistics_of(marks)
    with speaking(spoken_in(scene, language)):
        if out is not None:
            _write(out, [grades(marks)], "marks")
        if full is not None:
            _write_full(full, marks, book, statistics)
        if gradebook is not None:
            from tmmcalc.classroom.gradebook import gradebook as gradebook_of

            _write(gradebook, [gradebook_of(marks, scene.project.title or "tmmcalc")], "grades")
        if sheets is not None:
            _write_sheets(sheets, marks, sheet_form)
    show(marks_document(marks, statistics), form)
    if not quiet:
        note_written(*(file for file in (out, full, gradebook, sheets) if file is not None))


def _check(file: Path | None, flag: str, forms: Sequence[str]) -> None:
    if file is None:
        return
    check_place(file, flag)
    suffix = file.suffix.lower()
    if suffix not in forms:
        raise UsageError(f"{file} is no table of marks", where=flag, remedy=f"end its name in {', '.join(forms)}")
    if suffix == ".xlsx":
        available(Format.xlsx)
    elif suffix in PRINTED:
        from tmmcalc.note.forms import check_form

        check_form(suffix[1:], "a sheet", flag)


def _write_full(file: Path, marks: Marks, book: Keybook, statistics: Statistics) -> None:
    from tmmcalc.classroom.marksheets import teachers
    from tmmcalc.core.atomic import replace_file

    tables, suffix = teachers(marks, book, statistics), file.suffix.lower()
    if suffix in PRINTED:
        from tmmcalc.classroom.papers.results import teacher_results
        from tmmcalc.note.forms import formed

        title = tr("Marks")
        replace_file(file, formed(teacher_results(tables, title), suffix[1:], title))
        return
    _write(file, tables[1:2] if suffix == ".csv" else tables, "marks, with the key")


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


def _write_sheets(folder: Path, marks: Marks, form: str) -> None:
    from tmmcalc.classroom.roster import stem
    from tmmcalc.core.atomic import blamed_on, replace_file

    with blamed_on(folder, "made"):
        folder.mkdir(parents=True, exist_ok=True)
    for each in marks.counting:
        replace_file(folder / f"{stem(each.number, each.student)}.{form}", _sheet(marks, each, form))


def _sheet(marks: Marks, each: Marked, form: str) -> bytes:
    if form == "md":
        from tmmcalc.classroom.marksheets import students_sheet

        return students_sheet(marks, each).encode()
    from tmmcalc.classroom.papers.making import named
    from tmmcalc.classroom.papers.results import student_results
    from tmmcalc.note.forms import formed

    who = named(each.number, each.student)
    return formed(student_results(marks, each, who), form, who)
