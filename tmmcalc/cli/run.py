"""``tmmcalc run``."""

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
    stages,
)
from tmmcalc.cli.work import Job, title


def command(
    spec: SpecFile,
    target: Annotated[
        str | None,
        typer.Option("--to", metavar="STAGE", help="Stop after this stage.", show_default=False, autocompletion=stages),
    ] = None,
    form: Form = Format.table,
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
    """Run every stage that the spec has, layer by layer; print the summaries, leave all tables as files.

    Stages whose inputs are unchanged are loaded, not computed. A stage without a solution ends only those that read
    it; its error comes last.

    Example: tmmcalc run my.toml -o my.out
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or (), keep_going=True)
    scene = job.spec()
    result = job.run(scene, target)
    from tmmcalc.report.summary import run_document

    job.finish(run_document(result, title(scene, spec, "run")), result, form)
