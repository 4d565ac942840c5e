"""``tmmcalc reduce``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.makers import named_columns, positions_document
from tmmcalc.cli.options import Columns, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("reduction", asked=named_columns("reduction", "ordinates"))
def command(
    solved: Solved,
    columns: Columns = None,
    positions: Positions = None,
    ordinates: Annotated[
        bool, typer.Option("--ordinates", help="Print Simpson's rule over the positions, instead.")
    ] = False,
) -> Document:
    """Reduction: reduced moment of every load, weights, springs and friction, reduced inertia, work per cycle.

    Example: tmmcalc reduce my.toml --columns 'phi,M_red*,J_red'

    By name alone: inertia by link, by its mass and turning ('J_red_*,dJ_red_*'), weight by link (M_red_weight_*), value
    and transfer function of every load ('load_*,dS_of_*'), friction by pair (M_red_fr_*), ordinates of Simpson's rule
    ('Simpson,ordinate_*,sum_*').
    """
    if not ordinates:
        return positions_document(solved, columns, positions)
    from tmmcalc.machine.facts.ordinates import ordinates_document
    from tmmcalc.report.rows import rows_of

    return ordinates_document(
        solved.result,
        f"{solved.title}, Simpson's rule",
        patterns=patterns_of(columns),
        rows=rows_of(positions, solved.result.labels),
        everything=solved.everything,
    )
