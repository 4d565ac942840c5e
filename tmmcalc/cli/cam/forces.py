"""``tmmcalc cam forces``."""

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
    """Forces on the follower: spring, reactions with friction, jamming, loss of contact, torque and work of the cam.

    N1 and N2 are the edges of the guide, T is P_c S' on the camshaft, M_drive what it has to give with friction.

    Example: tmmcalc cam forces my.toml --columns "phi,P_c,R,T"
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "cam_forces")
    from tmmcalc.cli.positions import rows_of
    from tmmcalc.report.cams.forces import forces_document

    result = run.results["cam_forces"]
    document = forces_document(
        result,
        title(scene, job.file, "forces on the follower"),
        patterns=patterns,
        rows=rows_of(positions, result.positions.labels),
        everything=form is not Format.table,
    )
    job.finish(document, run, form)
