"""``tmmcalc gears compare``."""

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
    rows: Annotated[
        int, typer.Option("--rows", metavar="N", min=1, help="Trains of the Pareto front that the table shows.")
    ] = 20,
) -> None:
    """Mass, inertia, size and efficiency of all trains that are strong enough; Pareto front, minima, the best train.

    The table shows the Pareto front; --format csv, json or toml prints all trains.

    Example: tmmcalc gears compare my.toml
    """
    scene = job.spec()
    run = job.run(scene, "criteria")
    from tmmcalc.gears.facts.criteria import document as criteria_document

    everything = form is not Format.table
    result, heading = run.results["criteria"], title(scene, job.file, "comparison of gears")
    printed = criteria_document(result, heading, rows=rows, everything=everything)
    job.finish(printed, run, form)
