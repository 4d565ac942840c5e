"""``tmmcalc cam law``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
) -> None:
    """Motion of the follower over the turn: displacement and derivatives, constants of the laws, extremes, shocks.

    The table is in mm; --format csv, json or toml prints metres. A row 6- is the limit before a jump at position 6.

    Example: tmmcalc cam law my.toml --columns "phi,S*"
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "cam_law")
    from tmmcalc.cli.positions import rows_of
    from tmmcalc.report.cams.law import law_document

    result = run.results["cam_law"]
    document = law_document(
        result,
        title(scene, job.file, "law of motion"),
        patterns=patterns,
        rows=rows_of(positions, result.positions.labels),
        everything=form is not Format.table,
    )
    job.finish(document, run, form)
