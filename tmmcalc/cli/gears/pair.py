"""``tmmcalc gears pair``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.gears.drawn import length_of
from tmmcalc.cli.gears.known import Row, check_pair, of_pairs
from tmmcalc.cli.job import Job
from tmmcalc.cli.makers import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title


def _length(text: str) -> float:
    return length_of(text, "--sliding-step", "2 mm")


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
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
) -> None:
    """Pairs of gears: shifts, centre distance, radii, contact ratios, sliding; every condition with its margin.

    Of a [train] every mesh of the tooth set that was chosen. The table shows the radii; --format csv prints the
    sliding along the line of action, json and toml all of it. --sliding-step tabulates theta and lambda as
    program 1.15 does.

    Example: tmmcalc gears pair my.toml --pair 1-2 --sliding-step '2 mm'
    """
    job, scene = of_pairs(job, job.spec(), choose)
    check_pair(scene, pair)
    run = job.run(scene, "pair")
    from tmmcalc.gears.facts.pair import chosen_pairs, document

    result, heading = chosen_pairs(run.results["pair"], pair), title(scene, job.file, "pairs of gears")
    if angles:
        from tmmcalc.gears.facts.angles import angles_document

        job.finish(angles_document(result, heading, everything=form is not Format.table), run, form)
        return
    job.finish(document(result, heading, everything=form is not Format.table, step=step), run, form)
