"""A job: the flags that commands which run stages share, the pipeline once, what is told, how it ends; its commands."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.flags import CHOOSE, FORM, FOUND, own_of, signed, taken
from tmmcalc.cli.found import Target
from tmmcalc.cli.messages import note_written, put_bytes, tell_end
from tmmcalc.cli.options import Format, patterns_of
from tmmcalc.cli.output import Solved, check_place, check_strict, raise_failures, show, title, warnings_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.worksheets import Worksheet


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

    @property
    def run(self) -> Callable[[Spec, str | Sequence[str] | None], RunResult]:
        """The pipeline as the flags ask for it, with messages on standard error: ``run(spec, target)``."""
        from tmmcalc.cli.watching import StageWatch
        from tmmcalc.pipeline.runner import run

        return partial(
            run,
            out=self.folder,
            fresh=self.fresh,
            from_stage=self.from_stage,
            csv=self.csv,
            columns=self.columns,
            skip=self.skip,
            settings=self.settings,
            tolerance=self.tolerance,
            watch=StageWatch(self.folder, self._ended, quiet=self.quiet, verbose=self.verbose),
            keep_going=self.keep_going,
            wait=self.wait,
        )

    def _ended(self, spec: Spec, result: RunResult) -> RunResult:
        """What a run of the spec gives, with its pictures; the depfile is written."""
        if self.draw is not None and self.folder is not None:
            result = self.draw(result.spec, result, self.folder)
        self.done.append(result)
        if self.depfile is not None:
            from tmmcalc.pipeline.depfile import write
            from tmmcalc.project.files import named_files

            files = result.files if self.book is None else (*result.files, self.book)
            write(self.depfile, files, [self.file, *named_files(spec, self.file.parent)])
        return result

    def summarised(self, target: str | None) -> tuple[Document, RunResult]:
        """Run the spec; the document of its summaries."""
        from tmmcalc.pipeline.summary import run_document

        scene = self.spec()
        result = self.run(scene, target)
        return run_document(result, title(scene, self.file, "run")), result

    def with_book(self, form: Format | None, word: str) -> Job:
        """The job with the file of its workbook, if that is what it is to write; ``word`` is what the file is called.

        It is the one that ``-o`` names, or stands in its folder; without ``-o`` it goes to standard output, and where
        that is a terminal into the folder of the stage files.
        """
        named = self.out if self.out is not None and self.out.suffix.lower() == ".xlsx" else None
        if form is not Format.xlsx:
            if named is not None:
                raise UsageError(
                    f"{named} is the name of a workbook", where="-o", remedy="add --format xlsx, or name a folder"
                )
            return self
        if named is not None:
            check_place(named, "-o")
            return replace(self, out=None, book=named)
        if self.out is None and not sys.stdout.isatty():
            return self
        if self.folder is None:
            raise UsageError(
                "there is no folder for the workbook", where="--no-store", remedy="name its file, such as -o my.xlsx"
            )
        return replace(self, book=self.folder / f"{word}.xlsx")

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
            tell_end(result, self.folder, self.verbose)
        raise_failures(result.failures)
        self.check_warnings(document)

    def check_warnings(self, document: Document) -> None:
        """Under ``strict`` raise LimitError if a document warns."""
        check_strict(warnings_of(document), self.strict)


def with_flags(body: Callable[..., None]) -> Callable[..., None]:
    """The command that takes the shared flags and those of ``body``, and calls ``body(job, ...)``.

    A flag of the body's own stands in place of the shared one of its name.
    """
    own = own_of(body)

    def command(**given: Any) -> None:
        job = Job(**taken(given, own)).with_book(given.get("form"), body.__module__.rpartition(".")[2])
        with job.believed():
            body(job, **given)

    return signed(command, own, body)


def _read(job: Job, *, columns: str | None = None, **flags: Any) -> tuple[Job, Spec]:
    patterns_of(columns)
    return job, job.spec()


def of_stage(
    stage: str,
    heading: str = "",
    asked: Callable[..., tuple[Job, Spec]] = _read,
    *,
    found: str = "",
    several: bool = False,
) -> Callable[[Callable[..., Document]], Callable[..., None]]:
    """Make of ``body(solved, ...)`` the command that runs a stage and prints the document that ``body`` returns.

    Its flags are those of the body, ``form`` and the shared ones. The title says ``heading``, by default the stage.
    ``asked(job, **flags)`` reads the spec and says by which job it is run; before anything is computed it refuses flags
    that do not go together, and what the scene has not. ``found`` is the stage, this one or one that it needs, whose
    findings ``--spec`` writes into the spec; of ``several`` solutions ``--choose`` says which.
    """

    def made(body: Callable[..., Document]) -> Callable[..., None]:
        of_found = [*(FOUND if found else ()), *(CHOOSE if several else ())]
        own = [FORM, *of_found, *own_of(body)]

        def command(**given: Any) -> None:
            form = given.pop("form")
            job = Job(**taken(given, own)).with_book(form, stage)
            target = Target(job.file, *(given.pop(each.name) for each in of_found))
            target.check()
            job, scene = asked(job, **given)
            run = job.run(scene, stage)
            with job.believed():
                document = body(Solved(run.spec, job.file, run, stage, heading or stage, form), **given)
                settled = target.made(scene, found, run.results[found]) if found else None
                job.finish(document, run, form)
            target.write(settled, job.quiet)

        return signed(command, own, body)

    return made
