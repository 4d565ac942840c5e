"""``tmmcalc gears synth``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("train", "gears", found="train", several=True)
def command(
    solved: Solved,
    rows: Annotated[int, typer.Option("--rows", metavar="N", min=1, help="Tooth sets that the table shows.")] = 20,
) -> Document:
    """Tooth numbers: every set of a gear train within its constraints, and what each of these removed.

    The table shows the smallest sets; --format csv, json or toml prints all. --spec writes the spec with the teeth of
    the one that --choose names by its row i in train.csv.

    Example: tmmcalc gears synth my.toml --rows 50
    """
    return solved.document(rows=rows, everything=solved.everything)
