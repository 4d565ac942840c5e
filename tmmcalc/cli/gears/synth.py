"""``tmmcalc gears synth``."""

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
    rows: Annotated[int, typer.Option("--rows", metavar="N", min=1, help="Tooth sets that the table shows.")] = 20,
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
    """Tooth numbers: every set of a gear train within its constraints, and what each of these removed.

    The table shows the smallest sets; --format csv, json or toml prints all.

    Example: tmmcalc gears synth my.toml --rows 50
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "train")
    from tmmcalc.report.train import train_document

    everything = form is not Format.table
    printed = train_document(run.results["train"], title(scene, spec, "gears"), rows=rows, everything=everything)
    job.finish(printed, run, form)
