"""``tmmcalc gears pair``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.gears.drawn import length_of
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
    step: Annotated[
        str | None,
        typer.Option(
            "--sliding-step",
            metavar="LENGTH",
            help="Sliding in equal steps of rho1 from a quarter of it: '2 mm'.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Pairs of gears: shifts, centre distance, radii, contact ratios, sliding; every condition with its margin.

    Of a [train] every mesh of the tooth set that was chosen. The table shows the radii; --format csv prints the
    sliding along the line of action, json and toml all of it. --sliding-step tabulates theta and lambda as
    program 1.15 does.

    Example: tmmcalc gears pair my.toml --pair 1-2 --sliding-step '2 mm'
    """
    width = None if step is None else length_of(step, "--sliding-step", "2 mm")
    scene = job.spec()
    check_pair(scene, pair)
    run = job.run(scene, "pair")
    from tmmcalc.gears.facts.pair import chosen_pairs
    from tmmcalc.gears.facts.pair import document as pair_document

    result, heading = chosen_pairs(run.results["pair"], pair), title(scene, job.file, "pairs of gears")
    job.finish(pair_document(result, heading, everything=form is not Format.table, step=width), run, form)
