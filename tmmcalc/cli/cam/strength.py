"""``tmmcalc cam strength``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.work import Job, table_file, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    turn: Annotated[
        bool, typer.Option("--turn", help="Slip, stresses and moments over the turn in place of the margins.")
    ] = False,
    columns: Columns = None,
    positions: Positions = None,
) -> None:
    """Every requirement as a margin with its formula: slip, profile, pin, shaft, stem, guide, contact stress.

    What has no data is told as not judged. --columns and --positions choose from the table over the turn, which
    --format csv prints as well.

    Example: tmmcalc cam strength my.toml --turn --columns "phi,D,sigma_H"
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "cam_strength")
    from tmmcalc.cams.facts.cam_strength import document as strength_document
    from tmmcalc.cams.facts.cam_strength import turn_document
    from tmmcalc.report.rows import rows_of

    result, heading = run.results["cam_strength"], title(scene, job.file, "requirements of the cam")
    everything = form is not Format.table
    if turn or patterns or positions or form is Format.csv:
        rows = rows_of(positions, result.positions.labels)
        where = table_file(run, "cam_strength")
        printed = turn_document(result, heading, patterns=patterns, rows=rows, everything=everything, where=where)
    else:
        printed = strength_document(result, heading, everything=everything)
    job.finish(printed, run, form)
