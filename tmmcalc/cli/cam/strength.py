"""``tmmcalc cam strength``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Columns, Format, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("cam_strength", "requirements of the cam")
def command(
    solved: Solved,
    turn: Annotated[
        bool, typer.Option("--turn", help="Slip, stresses and moments over the turn in place of the margins.")
    ] = False,
    columns: Columns = None,
    positions: Positions = None,
) -> Document:
    """Every requirement as a margin with its formula: slip, profile, pin, shaft, stem, guide, contact stress.

    What has no data is told as not judged. --columns and --positions choose from the table over the turn, which
    --format csv prints as well. By name alone: pressure angle, force and reduced curvature (theta,R,kappa_red).

    Example: tmmcalc cam strength my.toml --turn --columns "phi,D,sigma_H"
    """
    result, patterns = solved.result, patterns_of(columns)
    if not (turn or patterns or positions or solved.form is Format.csv):
        return solved.document(everything=solved.everything)
    from tmmcalc.cams.facts.cam_strength import turn_document
    from tmmcalc.report.rows import rows_of

    return turn_document(
        result,
        solved.title,
        patterns=patterns,
        rows=rows_of(positions, result.positions.labels),
        everything=solved.everything,
        where=solved.where,
        **solved.further(patterns),
    )
