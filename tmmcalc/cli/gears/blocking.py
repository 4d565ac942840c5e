"""``tmmcalc gears blocking``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.gears.known import check_pair
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
) -> None:
    """Blocking contours: which shifts x1, x2 a pair may have, its corners, points of interest, margins of the choice.

    The tables show points and corners; --format csv prints the boundaries, json and toml all of it.

    Example: tmmcalc gears blocking my.toml
    """
    scene = job.spec()
    check_pair(scene, pair)
    run = job.run(scene, "blocking")
    from tmmcalc.gears.facts.blocking import chosen_contours
    from tmmcalc.gears.facts.blocking import document as blocking_document

    result, heading = chosen_contours(run.results["blocking"], pair), title(scene, job.file, "blocking contours")
    job.finish(blocking_document(result, heading, everything=form is not Format.table), run, form)
