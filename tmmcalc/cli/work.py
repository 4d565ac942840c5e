"""What every stage command does around its one call: spec in, pipeline, files, warnings, document out."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.messages import say, show_damage, show_error, show_event, whoever_reads
from tmmcalc.cli.options import Format
from tmmcalc.core.errors import LimitError, TmmError, UsageError
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import Event, RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document


@record
class Job:
    """The flags that all stage commands share."""

    file: Path
    out: Path | None = None
    store: bool = True
    fresh: bool = False
    from_stage: str | None = None
    csv: bool | None = None
    depfile: Path | None = None
    strict: bool = False
    quiet: bool = False
    overrides: Sequence[str] = ()
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    keep_going: bool = False
    tolerance: float | None = None  # relative error that is asked of every stage
    columns: Sequence[str] = ()  # names and wildcards of those that a CSV has; empty: all
    skip: Sequence[str] = ()  # stages that are left out

    def spec(self) -> Spec:
        """Read the spec with its overrides."""
        from tmmcalc.project import load_spec

        return load_spec(self.file, self.overrides)

    @property
    def folder(self) -> Path | None:
        """Where the stage files go; None if nothing is stored."""
        if not self.store:
            return None
        return self.out or Path(f"{self.file.stem}.out")

    def run(self, spec: Spec, target: str | None) -> RunResult:
        """Run the pipeline with messages on standard error, and write the depfile."""
        if self.depfile is not None:
            self._check_depfile(self.depfile)
        if self.quiet or not sys.stderr.isatty():
            result = self._run(spec, target, None, show_damage if self.quiet else show_event)
        else:
            from tmmcalc.cli.progress import Progress

            with Progress() as progress:
                result = self._run(spec, target, progress.start, progress.done)
        if self.depfile is not None:
            from tmmcalc.pipeline.depfile import write
            from tmmcalc.project.files import named_files

            write(self.depfile, result.files, [self.file, *named_files(spec, self.file.parent)])
        return result

    def summarised(self, target: str | None) -> tuple[Document, RunResult]:
        """Run the spec; the document of its summaries."""
        from tmmcalc.pipeline.summary import run_document

        scene = self.spec()
        result = self.run(scene, target)
        return run_document(result, title(scene, self.file, "run")), result

    def _run(
        self,
        spec: Spec,
        target: str | None,
        on_start: Callable[[str], None] | None,
        on_event: Callable[[Event], None],
    ) -> RunResult:
        from tmmcalc.pipeline.runner import run

        return run(
            spec,
            target=target,
            out=self.folder,
            fresh=self.fresh,
            from_stage=self.from_stage,
            csv=self.csv,
            columns=self.columns,
            skip=self.skip,
            settings=self.settings,
            tolerance=self.tolerance,
            on_start=on_start,
            on_event=on_event,
            keep_going=self.keep_going,
        )

    def _check_depfile(self, file: Path) -> None:
        """Refuse what would only come out after the computation."""
        if not self.store:
            raise UsageError(
                "--no-store leaves no files that could depend on the spec",
                where="--depfile",
                remedy="leave one of the two flags out",
            )
        check_place(file, "--depfile")

    def finish(self, document: Document, result: RunResult, form: Format) -> None:
        """Print the document, say where the files are; under ``strict`` warnings are the end."""
        from tmmcalc.report.errors import with_errors

        target = result.plan.target
        if target is not None and target in result.outcomes and not document.parts:
            document = with_errors(document, result.record(target).error)
        show(document, form)
        self.close(document, result)

    def close(self, document: Document, result: RunResult) -> None:
        """What comes after the document: where the files are, and the errors."""
        if result.files and not self.quiet:
            say(f"files in {self.folder}: {', '.join(file.name for file in result.files)}", "dim")
        raise_failures(result.failures)
        self.check_warnings(document)

    def check_warnings(self, document: Document) -> None:
        """Under ``strict`` raise LimitError if a document warns."""
        warnings = _warnings(document)
        if warnings and self.strict:
            count = f"{len(warnings)} warning{'s' if len(warnings) > 1 else ''}"
            raise LimitError(
                "\n  ".join((count, *warnings)), where="--strict", remedy="mend the causes, or leave --strict out"
            )


def raise_failures(failures: Mapping[str, TmmError]) -> None:
    """The errors of stages without a result: the first ends the command, the others are said before it."""
    errors = list(failures.values())
    for error in errors[1:]:
        show_error(error)
    if errors:
        raise errors[0]


def check_place(file: Path, where: str) -> None:
    """Raise UsageError unless a file can be in this place: its folder is there and it is none itself."""
    if file.is_dir():
        raise UsageError(f"{file} is a folder", where=where, remedy="name a file in it")
    if not file.parent.is_dir():
        raise UsageError(f"there is no folder {file.parent}", where=where, remedy="make it first, or choose another")


def check_apart(*files: Path | None) -> None:
    """Raise UsageError if two of the files to be written are the same one, so that the later would take its place."""
    told = [file for file in files if file is not None]
    for k, file in enumerate(told):
        if file.resolve() in {other.resolve() for other in told[:k]}:
            raise UsageError(f"{file} would be written twice", where="-o, --plot", remedy="name two files")


def check_picture(file: Path, where: str) -> None:
    """Raise UsageError if no picture could be drawn to a file; asked before the computation."""
    from tmmcalc.report.drawing import check_matplotlib, form_of

    check_place(file, where)
    form_of(file)
    check_matplotlib()


def check_tolerance(error: float) -> None:
    """Raise `UsageError` unless this is a relative error that could be asked for."""
    if not 0 < error < 1:
        raise UsageError(f"{error:g} is no relative error", where="--tolerance", remedy="write e.g. --tolerance 1e-6")


def table_file(run: RunResult, stage: str) -> str:
    """Where the whole table of a stage stands; empty if it was not written."""
    return next((str(file) for file in run.files if file.name == f"{stage}.csv"), "")


def title(spec: Spec, file: Path, what: str) -> str:
    """Heading of a document."""
    return f"{spec.project.title or file.stem}: {what}"


def deliver(document: Document, form: Format, out: Path | None) -> None:
    """Print a document, or write it to a file in one step."""
    if out is None:
        show(document, form)
        return
    from io import StringIO

    from tmmcalc.core.atomic import replace_file
    from tmmcalc.report.render import render

    text = StringIO()
    render(document, form.value, text)
    replace_file(out, text.getvalue().encode())


def show(document: Document, form: Format) -> None:
    """Print a document to standard output; csv has no place for warnings, so they go to standard error."""
    from tmmcalc.report.render import render

    if form is Format.csv:
        for warning in _warnings(document):
            say(warning, "yellow")
    with whoever_reads(sys.stdout):
        render(document, form.value)


def _warnings(document: Document) -> list[str]:
    own = [note for note in document.notes if note.startswith("warning")]
    return own + [warning for part in document.parts for warning in _warnings(part)]
