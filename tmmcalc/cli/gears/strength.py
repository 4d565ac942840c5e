"""``tmmcalc gears strength``."""

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
    train: Annotated[
        int | None,
        typer.Option(
            "--train", metavar="I", min=1, help="One set, by its row i, from 1: every coefficient.", show_default=False
        ),
    ] = None,
) -> None:
    """Modules and face widths of every tooth set by contact and bending, every coefficient with its source.

    The table shows the first sets; --format csv, json or toml prints all.

    Example: tmmcalc gears strength my.toml --train 3
    """
    scene = job.spec()
    run = job.run(scene, "strength")
    from tmmcalc.gears.facts.strength import document as strength_document
    from tmmcalc.gears.facts.strength import train_document

    result, heading = run.results["strength"], title(scene, job.file, "strength of gears")
    everything = form is not Format.table
    printed = (
        strength_document(result, heading, rows=rows, everything=everything)
        if train is None
        else train_document(result, heading, train)
    )
    job.finish(printed, run, form)
