"""What commands check before they write, and how they print and write documents."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.messages import counted, put_bytes, say, show_error, whoever_reads
from tmmcalc.cli.options import Format, check_named, language_of
from tmmcalc.core.errors import LimitError, TmmError, UsageError
from tmmcalc.core.files import other_kind
from tmmcalc.core.printable import printable
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document
    from tmmcalc.report.drawing.shapes import Drawing


@record
class Solved:
    """What a stage command prints a document of: the run of its stage, and how it is asked to print."""

    spec: Spec
    file: Path  # of the spec
    run: RunResult
    stage: str
    heading: str  # of the document, after the title of the project
    form: Format

    @property
    def title(self) -> str:
        """The title of the document."""
        return title(self.spec, self.file, self.heading)

    @property
    def result(self) -> Any:
        """The result of the stage."""
        return self.run.results[self.stage]

    @property
    def everything(self) -> bool:
        """Whether all rows are printed, for programs."""
        return self.form is not Format.table

    @property
    def where(self) -> str:
        """The file of the whole table; empty if it was not written."""
        return table_file(self.run, self.stage)

    def further(self, patterns: Sequence[str]) -> dict[str, Sequence[Column]]:
        """The columns by choice of the stage's rows, as an argument of its document; none without patterns."""
        own = self.run.outcomes[self.stage].stage
        found = own.further(self.spec, self.run.results) if patterns else ()
        return {"further": found} if found else {}

    def document(self, **chosen: Any) -> Document:
        """The document of the stage, with a table of what is chosen."""
        found: Document = self.run.outcomes[self.stage].stage.document(self.result, self.title, **chosen)
        return found


def raise_failures(failures: Mapping[str, TmmError]) -> None:
    """The errors of stages without a result: the first ends the command, the others are said before it, each once."""
    errors = list({str(error): error for error in reversed([*failures.values()])}.values())[::-1]
    for error in errors[1:]:
        show_error(error)
    if errors:
        raise errors[0]


def check_place(file: Path, where: str) -> None:
    """Raise UsageError unless a file can be in this place: its folder is there and it is none itself."""
    check_named(file, where)
    if kind := other_kind(file):
        remedy = "name a file in it" if kind == "a folder" else "name a file, or leave the flag out"
        raise UsageError(f"{file} is {kind}", where=where, remedy=remedy)
    if not file.parent.is_dir():
        raise UsageError(f"there is no folder {file.parent}", where=where, remedy="make it first, or choose another")


def check_apart(*files: Path | None, where: str = "-o, --plot") -> None:
    """Raise UsageError if two of the files to be written are the same one, so that the later would take its place."""
    told = [file for file in files if file is not None]
    for k, file in enumerate(told):
        if file.resolve() in {other.resolve() for other in told[:k]}:
            raise UsageError(f"{file} would be written twice", where=where, remedy="name two files")


def check_picture(file: Path, where: str) -> None:
    """Raise UsageError if no picture could be drawn to a file; asked before the computation."""
    from tmmcalc.report.drawing import check_writer, form_of

    check_place(file, where)
    check_writer(form_of(file))


def check_tolerance(error: float) -> None:
    """Raise `UsageError` unless this is a relative error that could be asked for."""
    if not 0 < error < 1:
        raise UsageError(f"{error:g} is no relative error", where="--tolerance", remedy="write e.g. --tolerance 1e-6")


def table_file(run: RunResult, stage: str) -> str:
    """Where the whole table of a stage stands; empty if it was not written."""
    return next((str(file) for file in run.files if file.name == f"{stage}.csv"), "")


def name(spec: Spec, file: Path) -> str:
    """What documents and pictures call a spec: its title, or that of its file."""
    return printable(spec.project.title or file.stem)


def title(spec: Spec, file: Path, what: str) -> str:
    """Heading of a document."""
    return f"{name(spec, file)}: {what}"


def draw_in(language: str | None, scene: Spec, file: Path, figure: Callable[[], Drawing]) -> None:
    """Write a picture in the language of the flag, or of the spec."""
    from tmmcalc.report.drawing import draw
    from tmmcalc.report.language import speaking

    with speaking(language_of(scene, language)):
        draw(file, figure)


def deliver(document: Document, form: Format, out: Path | None) -> None:
    """Print a document, or write it to a file in one step."""
    if out is None:
        show(document, form)
        return
    from io import StringIO

    from tmmcalc.core.atomic import replace_file
    from tmmcalc.report.render import render

    if form is Format.xlsx:
        replace_file(out, _workbook(document))
        return
    text = StringIO()
    render(document, form.value, text)
    replace_file(out, text.getvalue().encode())


def show(document: Document, form: Format) -> None:
    """Print a document to standard output; csv has no place for warnings, so they go to standard error."""
    from tmmcalc.report.render import render

    if form is Format.xlsx:
        put_bytes(_workbook(document))
        return
    if form is Format.csv:
        for warning in warnings_of(document):
            say(warning, "yellow")
    with whoever_reads(sys.stdout):
        render(document, form.value)


def _workbook(document: Document) -> bytes:
    from tmmcalc.report.workbook import workbook
    from tmmcalc.report.worksheets import sheets_of

    return workbook(sheets_of(document), document.title)


def check_strict(warnings: Sequence[str], strict: bool) -> None:
    """Under ``strict`` raise LimitError if there are warnings."""
    if warnings and strict:
        raise LimitError(
            "\n  ".join((counted(len(warnings), "warning"), *warnings)),
            where="--strict",
            remedy="mend the causes, or leave --strict out",
        )


def warnings_of(document: Document) -> list[str]:
    """The warnings among the notes of a document and its parts."""
    own = [note for note in document.notes if note.startswith("warning")]
    return own + [warning for part in document.parts for warning in warnings_of(part)]


def check_folders(files: Sequence[Path]) -> None:
    """Raise UsageError for specs whose stage files would go to one folder."""
    twice = [stem for stem, count in Counter(file.stem for file in files).items() if count > 1]
    if twice:
        raise UsageError(
            f"several specs are called {twice[0]}: they would have one folder, {twice[0]}.out",
            remedy="run them one by one, each with its own -o, or leave no files by --no-store",
        )
