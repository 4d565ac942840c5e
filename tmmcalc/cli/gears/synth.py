"""``tmmcalc gears synth``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    rows: Annotated[int, typer.Option("--rows", metavar="N", min=1, help="Tooth sets that the table shows.")] = 20,
) -> None:
    """Tooth numbers: every set of a gear train within its constraints, and what each of these removed.

    The table shows the smallest sets; --format csv, json or toml prints all.

    Example: tmmcalc gears synth my.toml --rows 50
    """
    scene = job.spec()
    run = job.run(scene, "train")
    from tmmcalc.gears.facts.train import document as train_document

    everything = form is not Format.table
    printed = train_document(run.results["train"], title(scene, job.file, "gears"), rows=rows, everything=everything)
    job.finish(printed, run, form)
