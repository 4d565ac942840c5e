"""What every command that runs stages is: shared flags in, the pipeline once, its document out."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, replace
from inspect import Parameter, Signature, signature
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.found import Choose, Force, SpecOut, Target
from tmmcalc.cli.messages import counted, note_written, put_bytes, say, show_damage, show_event, show_news
from tmmcalc.cli.options import (
    Columns,
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Positions,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
    Tolerance,
    Verbose,
    Wait,
    patterns_of,
)
from tmmcalc.cli.output import (
    check_place,
    check_strict,
    check_tolerance,
    raise_failures,
    show,
    table_file,
    title,
    warnings_of,
)
from tmmcalc.core.errors import UsageError
from tmmcalc.core.progress import tell
from tmmcalc.core.records import record
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.pipeline.outcome import Event, RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.worksheets import Worksheet

NAMED = 8  # tables or pictures that are told by their names


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
    wait: float | None = None  # seconds for another process that works in the folder
    done: list[RunResult] = field(default_factory=list)  # runs of this job
    verbose: bool = False
    draw: Callable[[Spec, RunResult, Path], RunResult] | None = None  # adds pictures to a run, in its folder
    book: Path | None = None  # file of the workbook, if that is asked for; None: standard output

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

    def run(self, spec: Spec, target: str | Sequence[str] | None) -> RunResult:
        """Run the pipeline with messages on standard error, and write the depfile."""
        from tmmcalc.pipeline.runner import run

        if self.depfile is not None:
            self._check_depfile(self.depfile)
        with self._stopped(), self._telling() as (on_start, on_event):
            result = run(
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
                wait=self.wait,
            )
        if self.draw is not None and self.folder is not None:
            result = self.draw(result.spec, result, self.folder)
        self.done.append(result)
        if self.depfile is not None:
            from tmmcalc.pipeline.depfile import write
            from tmmcalc.project.files import named_files

            files = result.files if self.book is None else (*result.files, self.book)
            write(self.depfile, files, [self.file, *named_files(spec, self.file.parent)])
        return result

    @contextmanager
    def _stopped(self) -> Iterator[None]:
        """Say what is kept if the run inside the block is interrupted."""
        try:
            yield
        except KeyboardInterrupt:
            if self.folder is not None and self.folder.is_dir():
                say(f"stopped: finished stages are kept in {self.folder}; the same command loads them", "yellow")
            raise

    @contextmanager
    def _telling(self) -> Iterator[tuple[Callable[[str], None] | None, Callable[[Event], None]]]:
        """What tells of a stage that is begun, if anything does, and of one that is done: live on a terminal."""
        show_one = show_damage if self.quiet else show_event if self.verbose else show_news
        if self.quiet or not sys.stderr.isatty():
            yield (lambda stage: tell(0.0, stage)), show_one
            return
        from tmmcalc.cli.progress import Progress

        with Progress(show_one) as progress:
            yield progress.start, progress.done

    def summarised(self, target: str | None) -> tuple[Document, RunResult]:
        """Run the spec; the document of its summaries."""
        from tmmcalc.pipeline.summary import run_document

        scene = self.spec()
        result = self.run(scene, target)
        return run_document(result, title(scene, self.file, "run")), result

    @contextmanager
    def believed(self) -> Iterator[None]:
        """Make documents of what was run inside the block; stored files that break them are the user's to mend."""
        try:
            yield
        except Exception:
            for run in self.done:
                with run.believed():
                    raise
            raise

    def _check_depfile(self, file: Path) -> None:
        """Refuse what would only come out after the computation."""
        if not self.store:
            raise UsageError(
                "--no-store leaves no files that could depend on the spec",
                where="--depfile",
                remedy="leave one of the two flags out",
            )
        check_place(file, "--depfile")

    def finish(
        self,
        document: Document,
        result: RunResult,
        form: Format,
        sheets: Callable[[], Sequence[Worksheet]] | None = None,
    ) -> None:
        """Print the document, say where the files are; under ``strict`` warnings are the end.

        Into a workbook go ``sheets``, by default those of the document.
        """
        from tmmcalc.report.errors import with_counters, with_errors

        document = replace(document, notes=(*document.notes, *result.told))
        target = result.plan.target
        if target is not None and target in result.outcomes and not document.parts:
            record = result.record(target)
            document = with_errors(document, record.error)
            if form in (Format.json, Format.toml, Format.xlsx):
                document = with_counters(document, record.counters)
        if form is Format.xlsx:
            from tmmcalc.pipeline.workbook import command_sheets

            self.write_book(sheets() if sheets is not None else command_sheets(result, document), document.title)
        else:
            show(document, form)
        self.close(document, result)

    def write_book(self, sheets: Sequence[Worksheet], title: str) -> None:
        """Write a workbook where it is to be."""
        from tmmcalc.core.atomic import replace_file
        from tmmcalc.report.workbook import workbook

        data = workbook(sheets, title)
        if self.book is None:
            put_bytes(data)
            return
        replace_file(self.book, data)
        if not self.quiet:
            note_written(self.book)

    def close(self, document: Document, result: RunResult) -> None:
        """What comes after the document: where the files are, and the errors."""
        if not self.quiet:
            self._tell_end(result)
        raise_failures(result.failures)
        self.check_warnings(document)

    def _tell_end(self, result: RunResult) -> None:
        """How many stages ran and how long, which ``verbose`` has told of each; the files."""
        if not self.verbose:
            done = {kind: [event for event in result.events if event.kind == kind] for kind in ("computed", "loaded")}
            told = [f"{counted(len(events), 'stage')} {kind}" for kind, events in done.items() if events]
            seconds = sum(event.seconds for events in done.values() for event in events)
            if told:
                say(f"{', '.join(told)} in {f'{seconds:.1f} s' if seconds >= 1 else f'{seconds * 1000:.0f} ms'}", "dim")
        if result.files:
            say(f"files in {self.folder}: {', '.join(self._named(result.files))}", "dim")

    def _named(self, files: Sequence[Path]) -> list[str]:
        """The files in words: by name those for people, if they are few; all of them if ``verbose``."""
        if self.verbose:
            return [file.name for file in files]
        told = []
        for thing, suffix in (("table", ".csv"), ("picture", ".svg")):
            names = [file.name for file in files if file.suffix == suffix]
            told += names if len(names) <= NAMED else [f"{counted(len(names), thing)} ({suffix[1:]})"]
        rest = sum(file.suffix not in (".csv", ".svg") for file in files)
        return [*told, counted(rest, "file") + " of the stages"] if rest else told

    def check_warnings(self, document: Document) -> None:
        """Under ``strict`` raise LimitError if a document warns."""
        check_strict(warnings_of(document), self.strict)


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


def with_flags(body: Callable[..., None]) -> Callable[..., None]:
    """The command that takes the shared flags and those of ``body``, and calls ``body(job, ...)``.

    A flag of the body's own stands in place of the shared one of its name.
    """
    own = _own(body)

    def command(**given: Any) -> None:
        job = _with_book(_taken(given, own), given.get("form"), body.__module__.rpartition(".")[2])
        with job.believed():
            body(job, **given)

    return _signed(command, own, body)


def of_stage(
    stage: str,
    heading: str = "",
    check: Callable[..., None] = lambda spec, **flags: None,
    *,
    found: str = "",
    several: bool = False,
) -> Callable[[Callable[..., Document]], Callable[..., None]]:
    """Make of ``body(solved, ...)`` the command that runs a stage and prints the document that ``body`` returns.

    Its flags are those of the body, ``form`` and the shared ones. The title says ``heading``, by default the stage.
    Before anything is run ``check(spec, **flags)`` refuses what the scene has not, and columns that name nothing are
    refused. ``found`` is the stage, this one or one that it needs, whose findings ``--spec`` writes into the spec; of
    ``several`` solutions ``--choose`` says which.
    """

    def made(body: Callable[..., Document]) -> Callable[..., None]:
        own = [FORM, *(FOUND if found else ()), *(CHOOSE if several else ()), *_own(body)]

        def command(**given: Any) -> None:
            form = given.pop("form")
            job = _with_book(_taken(given, own), form, stage)
            target = Target(job.file, *(given.pop(each.name, each.default) for each in (*FOUND, *CHOOSE)))
            target.check()
            patterns_of(given.get("columns"))
            scene = job.spec()
            check(scene, **given)
            run = job.run(scene, stage)
            with job.believed():
                document = body(Solved(run.spec, job.file, run, stage, heading or stage, form), **given)
                settled = target.made(scene, found, run.results[found]) if found else None
                job.finish(document, run, form)
            target.write(settled, job.quiet)

        return _signed(command, own, body)

    return made


def stage_command(stage: str, text: str, heading: str = "") -> Callable[..., None]:
    """The command of a stage with positions, whose help is ``text``.

    The document is chosen by ``patterns``, ``rows``, ``everything``, ``where``; of a stage with columns by choice by
    these too, as ``further``.
    """

    def body(solved: Solved, columns: Columns = None, positions: Positions = None) -> Document:
        return positions_document(solved, columns, positions)

    body.__doc__ = text
    return of_stage(stage, heading)(body)


def positions_document(solved: Solved, columns: str | None, positions: str | None) -> Document:
    """The document of a stage with positions, with the columns, those by choice among them, and rows that are named."""
    from tmmcalc.report.rows import rows_of

    patterns = patterns_of(columns)
    return solved.document(
        patterns=patterns,
        rows=rows_of(positions, solved.result.labels),
        everything=solved.everything,
        where=solved.where,
        **solved.further(patterns),
    )


def summary_command(
    stage: str, text: str, heading: str = "", *, forms: bool = False, found: bool = False
) -> Callable[..., None]:
    """The command of a stage without positions, whose help is ``text``.

    With ``forms`` its document is told as ``everything`` whether a format for programs is asked for; with ``found``
    what it finds can be written into the spec.
    """

    def body(solved: Solved) -> Document:
        return solved.document(**({"everything": solved.everything} if forms else {}))

    body.__doc__ = text
    return of_stage(stage, heading, found=stage if found else "")(body)


def _own(body: Callable[..., Any]) -> list[Parameter]:
    """The flags of a body: all parameters but the first."""
    return list(signature(body, eval_str=True).parameters.values())[1:]


def _signed(command: Callable[..., None], own: Sequence[Parameter], body: Callable[..., Any]) -> Callable[..., None]:
    """The command with the flags that typer is to give it, the spec first, and the help of ``body``."""
    taken = {parameter.name for parameter in own}
    spec, *rest = (each for each in SHARED if each.name not in taken)
    listed = [spec, *own, *rest]
    assert all(parameter.kind is Parameter.POSITIONAL_OR_KEYWORD for parameter in listed)
    vars(command)["__signature__"] = Signature(listed)
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in listed}
    command.__doc__ = body.__doc__
    return command


def _taken(given: dict[str, Any], own: Sequence[Parameter]) -> Job:
    """The job of the shared flags, which are taken out of what is given."""
    taken = {parameter.name for parameter in own}
    return _job(**{each.name: given.pop(each.name) for each in SHARED if each.name not in taken})


def _with_book(job: Job, form: Format | None, word: str) -> Job:
    """The job with the file of its workbook, if that is what it is to write; ``word`` is what the file is called.

    It is the one that ``-o`` names, or stands in its folder; without ``-o`` it goes to standard output, and where that
    is a terminal into the folder of the stage files.
    """
    named = job.out if job.out is not None and job.out.suffix.lower() == ".xlsx" else None
    if form is not Format.xlsx:
        if named is not None:
            raise UsageError(
                f"{named} is the name of a workbook", where="-o", remedy="add --format xlsx, or name a folder"
            )
        return job
    if named is not None:
        check_place(named, "-o")
        return replace(job, out=None, book=named)
    if job.out is None and not sys.stdout.isatty():
        return job
    if job.folder is None:
        raise UsageError(
            "there is no folder for the workbook", where="--no-store", remedy="name its file, such as -o my.xlsx"
        )
    return replace(job, book=job.folder / f"{word}.xlsx")


def _job(
    spec: SpecFile,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    tolerance: Tolerance = None,
    overrides: Set = None,
    wait: Wait = None,
    verbose: Verbose = False,
) -> Job:
    if quiet and verbose:
        raise UsageError("says less, -v more", where="-q", remedy="leave one of the two out")
    if tolerance is not None:
        check_tolerance(tolerance)
    if wait is not None and isnan(wait):
        raise UsageError("nan is no time", where="--wait", remedy="write seconds, such as --wait 10")
    flags = (spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    return Job(*flags, tolerance=tolerance, wait=wait, verbose=verbose)


SHARED = tuple(signature(_job, eval_str=True).parameters.values())  # flags of all stage commands
FORM = Parameter("form", Parameter.POSITIONAL_OR_KEYWORD, default=Format.table, annotation=Form)
FOUND = (
    Parameter("spec_out", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=SpecOut),
    Parameter("force", Parameter.POSITIONAL_OR_KEYWORD, default=False, annotation=Force),
)
CHOOSE = (Parameter("choose", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=Choose),)
