"""``tmmcalc run``."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format, stages
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    target: Annotated[
        str | None,
        typer.Option("--to", metavar="STAGE", help="Stop after this stage.", show_default=False, autocompletion=stages),
    ] = None,
    form: Form = Format.table,
) -> None:
    """Run every stage that the spec has, layer by layer; print the summaries, leave all tables as files.

    Stages whose inputs are unchanged are loaded, not computed. A stage without a solution ends only those that read
    it; its error comes last.

    Example: tmmcalc run my.toml -o my.out
    """
    job = replace(job, keep_going=True)
    scene = job.spec()
    result = job.run(scene, target)
    from tmmcalc.report.summary import run_document

    job.finish(run_document(result, title(scene, job.file, "run")), result, form)
