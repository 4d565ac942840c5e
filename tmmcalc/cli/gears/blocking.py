"""``tmmcalc gears blocking``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.gears.known import check_pair
from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def _asked(job: Job, *, pair: str | None) -> tuple[Job, Spec]:
    scene = job.spec()
    check_pair(scene, pair)
    return job, scene


@of_stage("blocking", "blocking contours", _asked)
def command(
    solved: Solved,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
) -> Document:
    """Blocking contours: which shifts x1, x2 a pair may have, its corners, points of interest, margins of the choice.

    The tables show points and corners; --format csv prints the boundaries, json and toml all of it.

    Example: tmmcalc gears blocking my.toml
    """
    from tmmcalc.gears.facts.blocking import chosen_contours, document

    return document(chosen_contours(solved.result, pair), solved.title, everything=solved.everything)
