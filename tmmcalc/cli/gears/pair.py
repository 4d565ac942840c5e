"""``tmmcalc gears pair``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.gears.drawn import length_of
from tmmcalc.cli.gears.known import check_pair
from tmmcalc.cli.job import Solved, of_stage
from tmmcalc.report.document import Document


def _length(text: str) -> float:
    return length_of(text, "--sliding-step", "2 mm")


@of_stage("pair", "pairs of gears", check_pair)
def command(
    solved: Solved,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
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
) -> Document:
    """Pairs of gears: shifts, centre distance, radii, contact ratios, sliding; every condition with its margin.

    Of a [train] every mesh of the tooth set that was chosen. The table shows the radii; --format csv prints the
    sliding along the line of action, json and toml all of it. --sliding-step tabulates theta and lambda as
    program 1.15 does.

    Example: tmmcalc gears pair my.toml --pair 1-2 --sliding-step '2 mm'
    """
    from tmmcalc.gears.facts.pair import chosen_pairs, document

    return document(chosen_pairs(solved.result, pair), solved.title, everything=solved.everything, step=step)
