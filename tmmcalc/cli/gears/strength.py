"""``tmmcalc gears strength``."""

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
    train: Annotated[
        int | None,
        typer.Option(
            "--train", metavar="I", min=1, help="One set, by its row i, from 1: every coefficient.", show_default=False
        ),
    ] = None,
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
    """Modules and face widths of every tooth set by contact and bending, every coefficient with its source.

    The table shows the first sets; --format csv, json or toml prints all.

    Example: tmmcalc gears strength my.toml --train 3
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "strength")
    from tmmcalc.report.strength import strength_document, train_document

    result, heading = run.results["strength"], title(scene, spec, "strength of gears")
    everything = form is not Format.table
    printed = (
        strength_document(result, heading, rows=rows, everything=everything)
        if train is None
        else train_document(result, heading, train)
    )
    job.finish(printed, run, form)
