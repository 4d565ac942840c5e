"""A job: the flags that all commands which run stages share, the pipeline once, what is told, and how it ends."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.messages import counted, note_written, put_bytes, say, show_damage, show_event, show_news
from tmmcalc.cli.options import Format
from tmmcalc.cli.output import check_place, check_strict, raise_failures, show, title, warnings_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.progress import tell
from tmmcalc.core.records import record
from tmmcalc.report.document import Document

if TYPE_CHECKING:
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
