"""``tmmcalc cam law``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.makers import named_columns
from tmmcalc.cli.options import Columns, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document
from tmmcalc.report.rows import rows_of


@of_stage("cam_law", "law of motion", named_columns("cam_law"))
def command(
    solved: Solved,
    columns: Columns = None,
    positions: Positions = None,
    constants: Annotated[
        bool, typer.Option("--constants", help="Print the laws alone, by phase, with their coefficients, instead.")
    ] = False,
) -> Document:
    """Motion of the follower over the turn: displacement and derivatives, constants of the laws, extremes, shocks.

    The table is in mm; --format csv, json or toml prints metres. A row 6- is the limit before a jump at position 6.
    By name alone: the law by the part k of its phase (s,s1,s2,s3).

    Example: tmmcalc cam law my.toml --columns "phi,S*"
    """
    patterns = patterns_of(columns)
    if constants:
        given = [flag for flag, value in (("--columns", columns), ("--positions", positions)) if value is not None]
        if given:
            raise UsageError("--constants has no rows over the turn", where=", ".join(given), remedy="leave it out")
        from tmmcalc.cams.facts.law_constants import constants_document
        from tmmcalc.cams.laws.details import phase_laws
        from tmmcalc.cams.tables.tasks.cam import to_cam

        laws = phase_laws(to_cam(solved.spec).program, solved.result.turns, solved.result.speed)
        return constants_document(solved.result, laws, solved.title, everything=solved.everything)
    return solved.document(
        patterns=patterns,
        rows=rows_of(positions, solved.result.labels),
        everything=solved.everything,
        where=solved.where,
        **solved.further(patterns),
    )
