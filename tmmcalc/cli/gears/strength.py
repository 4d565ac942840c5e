"""``tmmcalc gears strength``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import Solved, of_stage
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
) -> Document:
    """Modules and face widths of every tooth set by contact and bending, every coefficient with its source.

    The table shows the first sets; --format csv, json or toml prints all.

    Example: tmmcalc gears strength my.toml --train 3
    """
    if train is None:
        return solved.document(rows=rows, everything=solved.everything)
    from tmmcalc.gears.facts.strength import train_document

    return train_document(solved.result, solved.title, train)
