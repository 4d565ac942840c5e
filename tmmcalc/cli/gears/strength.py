"""``tmmcalc gears strength``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("strength", "strength of gears")
def command(
    solved: Solved,
    rows: Annotated[int, typer.Option("--rows", metavar="N", min=1, help="Tooth sets that the table shows.")] = 20,
    train: Annotated[
        int | None,
        typer.Option(
            "--train", metavar="I", min=1, help="One set, by its row i, from 1: every coefficient.", show_default=False
        ),
    ] = None,
    factors: Annotated[
        bool,
        typer.Option(
            "--factors",
            help="One set step by step: cells of tables, formulas with numbers (default: the first strong enough).",
        ),
    ] = False,
) -> Document:
    """Modules and face widths of every tooth set by contact and bending, every coefficient with its source.

    The table shows the first sets; --format csv, json or toml prints all. --factors tells of the set of --train each
    factor with the table, row and column it is read from, or its formula with numbers, up to the stresses.

    Example: tmmcalc gears strength my.toml --train 3
    """
    if factors:
        from tmmcalc.gears.details import sized_train
        from tmmcalc.gears.facts.factors import factors_document
        from tmmcalc.gears.strength.chain import strength_factors

        sized, at, row = sized_train(solved.run.results, train)
        told = strength_factors(sized.sets, sized.task, at)
        return factors_document(told, f"{solved.title}, row {row}", everything=solved.everything)
    if train is None:
        return solved.document(rows=rows, everything=solved.everything)
    from tmmcalc.gears.facts.strength import train_document

    return train_document(solved.result, solved.title, train)
