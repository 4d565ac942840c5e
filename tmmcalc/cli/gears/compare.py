"""``tmmcalc gears compare``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("criteria", "comparison of gears", found="criteria", several=True)
def command(
    solved: Solved,
    rows: Annotated[
        int, typer.Option("--rows", metavar="N", min=1, help="Trains of the Pareto front that the table shows.")
    ] = 20,
) -> Document:
    """Mass, inertia, size and efficiency of all trains that are strong enough; Pareto front, minima, the best train.

    The table shows the Pareto front; --format csv, json or toml prints all trains. --spec writes the spec with the
    teeth of the best train, or of the one that --choose names by its row i in criteria.csv.

    Example: tmmcalc gears compare my.toml
    """
    return solved.document(rows=rows, everything=solved.everything)
