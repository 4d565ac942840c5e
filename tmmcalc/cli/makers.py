"""Makers of commands: of a function of a job, or of the result of a stage, they make what typer calls."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from inspect import Parameter, Signature, signature
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.found import Choose, Force, SpecOut, Target
from tmmcalc.cli.job import Job
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
from tmmcalc.cli.output import check_place, check_tolerance, table_file, title
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec


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
    return of_stage(stage, heading, named_columns(stage))(body)


def named_columns(stage: str, unless: str = "") -> Callable[..., None]:
    """The check, for `of_stage`, that every name of --columns may be one of the stage's table.

    It is passed over under the flag ``unless``, which prints another table.
    """

    def check(spec: Spec, columns: str | None = None, **flags: Any) -> None:
        if columns is not None and not flags.get(unless):
            check_names(columns, stage, spec)

    return check


def check_names(columns: str | None, stage: str, spec: Spec) -> None:
    """Refuse names of --columns that no column of the stage can have, before anything is computed."""
    if patterns := patterns_of(columns):
        from tmmcalc.naming.declared import check_columns
        from tmmcalc.rooms import STAGES

        check_columns(patterns, [STAGES[stage]], spec)


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
