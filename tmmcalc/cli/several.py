"""Several specs run by one command: each for itself, and what became of all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from tmmcalc.batch.task import verdict
from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import put, say, show_error
from tmmcalc.cli.options import Format
from tmmcalc.cli.output import check_folders, show
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.report.document import Document


@record
class _End:
    """What became of a spec."""

    file: Path
    document: Document | None
    code: int
    reason: str


def run_all(job: Job, files: Sequence[Path], target: str | None, form: Format) -> None:
    """Run the specs one after the other and print what became of them; the exit code is the largest of all.

    Raises UsageError for two specs that would have one folder.
    """
    _check(job, files, form)
    ends = []
    for at, file in enumerate(files):
        if not job.quiet:
            say(f"{file} ({at + 1} of {len(files)})", "dim")
        own = replace(job, file=file, out=job.out / f"{file.stem}.out" if job.out is not None else None)
        ends.append(_end(own, target, form))
    printed = Format.table if form is Format.xlsx else form  # each spec has its own workbook
    show(_document(ends, printed), printed)
    raise typer.Exit(max(end.code for end in ends))


def _check(job: Job, files: Sequence[Path], form: Format) -> None:
    if job.store:
        check_folders(files)
    if form is Format.xlsx and ((job.book is not None and job.out is None) or not job.store):
        where = "-o" if job.store else "--no-store"
        raise UsageError("every spec has its own workbook", where=where, remedy="name a folder, -o FOLDER, or none")
    if job.depfile is not None:
        raise UsageError("is that of one spec", where="--depfile", remedy="run the specs one by one")


def _end(job: Job, target: str | None, form: Format) -> _End:
    """Run one spec; its summary is printed at once as a table, its workbook stands in its folder."""
    document = None
    try:
        document, result = job.summarised(target)
        if form is Format.xlsx and job.folder is not None:
            from tmmcalc.pipeline.workbook import run_sheets

            book = replace(job, book=job.folder / "run.xlsx")
            book.write_book(run_sheets(result, job.csv, job.columns), document.title)
        if form is Format.table:
            show(replace(document, title=f"{job.file}, {document.title}"), form)
            put("\n")
        job.close(document, result)
    except TmmError as error:
        show_error(error)
        return _End(job.file, document, error.exit_code, verdict(error)[1])
    return _End(job.file, document, 0, "")


def _document(ends: Sequence[_End], form: Format) -> Document:
    """What became of every spec; for programs with the summaries, which have been printed otherwise."""
    from tmmcalc.report.document import Document, Fact, View

    failed = sum(end.code > 0 for end in ends)
    fact = Fact("specs", f"{len(ends)}, {failed} of them failed", {"specs": len(ends), "failed": failed})
    results = [f"failed {end.code}" if end.code else "ok" for end in ends]
    view = View(["spec", "result", "reason"], [[str(end.file) for end in ends], results, [end.reason for end in ends]])
    told = [replace(end.document, title=str(end.file)) for end in ends if end.document is not None]
    return Document("Run of several specs", (fact,), table=view, parts=() if form is Format.table else tuple(told))
