"""``tmmcalc cam optimize``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
) -> None:
    """The lowest mechanism within all constraints: least height H2, start distance, roller, active constraints.

    Also the blocking contour with its corners, what relaxing a limit buys, and the laws, springs, materials and
    rollers compared that [cam.optimum] names. --format json and toml print all of it, with the borders of the contour.

    Example: tmmcalc cam optimize my.toml --set cam.requirements.contact="450 MPa"
    """
    scene = job.spec()
    run = job.run(scene, "cam_optimum")
    from tmmcalc.report.cams.optimum import optimum_document

    heading = title(scene, job.file, "optimal design of the cam")
    job.finish(optimum_document(run.results["cam_optimum"], heading, everything=form is not Format.table), run, form)
