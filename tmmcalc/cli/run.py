"""``tmmcalc run``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format, Language, Skip, patterns_of, stages
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.worksheets import Worksheet


@with_flags
def command(
    job: Job,
    others: Annotated[
        list[Path] | None, typer.Argument(help="Further specs.", metavar="[SPEC]...", show_default=False)
    ] = None,
    target: Annotated[
        str | None,
        typer.Option("--to", metavar="STAGE", help="Stop after this stage.", show_default=False, autocompletion=stages),
    ] = None,
    skip: Skip = None,
    columns: Annotated[
        str | None,
        typer.Option(
            "--columns",
            metavar="NAMES",
            help="Columns that the CSV files have, with wildcards: 'phi,R_*' (default: all but those by choice).",
            show_default=False,
        ),
    ] = None,
    plots: Annotated[
        bool, typer.Option("--plots", help="Draw every stage that has a picture, beside its tables.")
    ] = False,
    language: Language = None,
    form: Form = Format.table,
) -> None:
    """Run every stage that the spec has, layer by layer; print the summaries, leave all tables as files.

    Stages whose inputs are unchanged are loaded, not computed. A stage without a solution ends only those that read
    it; its error comes last.

    Of several specs each has its folder <spec>.out, in that of -o if it is given. One that fails does not stop the
    others; the exit code is the largest.

    Example: tmmcalc run my.toml --plots -o my.out
    """
    _check_columns(job, columns)
    job = replace(job, keep_going=True, columns=patterns_of(columns), skip=skip or ())
    if plots:
        job = replace(job, draw=_drawing(job, language))
    elif language is not None:
        raise UsageError("nothing is drawn", where="--language", remedy="add --plots, or leave it out")
    if others:
        from tmmcalc.cli.several import run_all

        run_all(job, [job.file, *others], target, form)
    else:
        document, result = job.summarised(target)
        job.finish(document, result, form, partial(_sheets, job, result))


def _sheets(job: Job, result: RunResult) -> list[Worksheet]:
    from tmmcalc.pipeline.workbook import run_sheets

    return run_sheets(result, job.csv, job.columns)


def _drawing(job: Job, language: str | None) -> Callable[[Spec, RunResult, Path], RunResult]:
    """What adds the pictures to a run; refused at once where there is no folder for them."""
    if not job.store:
        raise UsageError("--no-store leaves no folder for pictures", where="--plots", remedy="leave one of the two out")
    from tmmcalc.cli.plot import looking, with_pictures

    def drawn(spec: Spec, run: RunResult, folder: Path) -> RunResult:
        with looking(spec, language):
            return with_pictures(spec, run, folder, quiet=job.quiet)

    return drawn


def _check_columns(job: Job, columns: str | None) -> None:
    """Refuse a choice of columns of files that are not written."""
    if columns is not None and (not job.store or job.csv is False):
        flag = "--no-csv" if job.store else "--no-store"
        raise UsageError(f"{flag} writes no CSV files", where="--columns", remedy="leave one of the two flags out")
