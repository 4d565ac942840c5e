"""``tmmcalc motion``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.makers import named_columns, positions_document
from tmmcalc.cli.options import Columns, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("motion", asked=named_columns("motion", "recurrence"))
def command(
    solved: Solved,
    columns: Columns = None,
    positions: Positions = None,
    recurrence: Annotated[
        bool, typer.Option("--recurrence", help="Print the textbook's recurrence (3.57) term by term, instead.")
    ] = False,
) -> Document:
    """Motion: the steady motion of the machine under its motor, or under a constant driving moment.

    Example: tmmcalc motion my.toml --columns 'phi,omega*' --positions 0:24:4

    By name alone: terms of the recurrence ('step_*'), its speeds turn by turn ('omega_turn_*'), the same without
    technological loads ('omega_idle_t*').
    """
    if not recurrence:
        return positions_document(solved, columns, positions)
    from tmmcalc.machine.facts.stepwise import recurrence_document
    from tmmcalc.report.rows import rows_of

    return recurrence_document(
        solved.result,
        solved.run.results["reduction"],
        f"{solved.title}, recurrence",
        patterns=patterns_of(columns),
        rows=rows_of(positions, solved.result.labels),
        everything=solved.everything,
    )
