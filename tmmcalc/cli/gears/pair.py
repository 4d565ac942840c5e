"""``tmmcalc gears pair``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.gears.drawn import length_of
from tmmcalc.cli.gears.known import Row, check_pair, of_pairs
from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def _length(text: str) -> float:
    return length_of(text, "--sliding-step", "2 mm")


def _asked(job: Job, *, pair: str | None, choose: int | None, **others: object) -> tuple[Job, Spec]:
    job, scene = of_pairs(job, job.spec(), choose)
    check_pair(scene, pair)
    return job, scene


@of_stage("pair", "pairs of gears", _asked)
def command(
    solved: Solved,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
    choose: Row = None,
    step: Annotated[
        float | None,
        typer.Option(
            "--sliding-step",
            parser=_length,
            metavar="LENGTH",
            help="Sliding in equal steps of rho1 from a quarter of it: '2 mm'.",
            show_default=False,
        ),
    ] = None,
    angles: Annotated[
        bool,
        typer.Option("--angles", help="Instead: every intermediate angle, involute and length, formulas with numbers."),
    ] = False,
) -> Document:
    """Pairs of gears: shifts, centre distance, radii, contact ratios, sliding; every condition with its margin.

    Of a [train] every mesh of the tooth set that was chosen. The table shows the radii; --format csv prints the
    sliding along the line of action, json and toml all of it. --sliding-step tabulates theta and lambda as
    program 1.15 does.

    Example: tmmcalc gears pair my.toml --pair 1-2 --sliding-step '2 mm'
    """
    from tmmcalc.gears.facts.pair import chosen_pairs, document

    result = chosen_pairs(solved.result, pair)
    if angles:
        from tmmcalc.gears.facts.angles import angles_document

        return angles_document(result, solved.title, everything=solved.everything)
    return document(result, solved.title, everything=solved.everything, step=step)
