"""``tmmcalc gears compare``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.options import (
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
)
from tmmcalc.cli.work import Job, title


def command(
    spec: SpecFile,
    form: Form = Format.table,
    rows: Annotated[
        int, typer.Option("--rows", metavar="N", min=1, help="Trains of the Pareto front that the table shows.")
    ] = 20,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Mass, inertia, size and efficiency of all trains that are strong enough; Pareto front, minima, the best train.

    The table shows the Pareto front; --format csv, json or toml prints all trains.

    Example: tmmcalc gears compare my.toml
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "criteria")
    from tmmcalc.report.criteria import criteria_document

    everything = form is not Format.table
    result, heading = run.results["criteria"], title(scene, spec, "comparison of gears")
    printed = criteria_document(result, heading, rows=rows, everything=everything)
    job.finish(printed, run, form)
