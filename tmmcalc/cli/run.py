"""``tmmcalc run``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format, Skip, patterns_of, stages
from tmmcalc.core.errors import UsageError


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
            help="Columns that the CSV files have, with wildcards: 'phi,R_*' (default: all).",
            show_default=False,
        ),
    ] = None,
    form: Form = Format.table,
) -> None:
    """Run every stage that the spec has, layer by layer; print the summaries, leave all tables as files.

    Stages whose inputs are unchanged are loaded, not computed. A stage without a solution ends only those that read
    it; its error comes last.

    Of several specs each has its folder <spec>.out, in that of -o if it is given. One that fails does not stop the
    others; the exit code is the largest.

    Example: tmmcalc run my.toml -o my.out
    """
    _check_columns(job, columns)
    job = replace(job, keep_going=True, columns=patterns_of(columns), skip=skip or ())
    if others:
        from tmmcalc.cli.several import run_all

        run_all(job, [job.file, *others], target, form)
    else:
        document, result = job.summarised(target)
        job.finish(document, result, form)


def _check_columns(job: Job, columns: str | None) -> None:
    """Refuse a choice of columns of files that are not written."""
    if columns is not None and (not job.store or job.csv is False):
        flag = "--no-csv" if job.store else "--no-store"
        raise UsageError(f"{flag} writes no CSV files", where="--columns", remedy="leave one of the two flags out")
