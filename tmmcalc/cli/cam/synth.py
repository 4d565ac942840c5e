"""``tmmcalc cam synth``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
) -> None:
    """Sizes of the cam by its pressure angle, textbook and exact optimum side by side; the roller; the angle over phi.

    --format csv prints the pressure angle at all positions, json and toml the admissible region of the axis as well.

    Example: tmmcalc cam synth my.toml
    """
    scene = job.spec()
    run = job.run(scene, "cam_pressure")
    from tmmcalc.cams.facts.cam_pressure import document as pressure_document
    from tmmcalc.cams.facts.cam_synthesis import document as synthesis_document
    from tmmcalc.report.document import Document

    everything, heading = form is not Format.table, title(scene, job.file, "synthesis of the cam")
    found = synthesis_document(run.results["cam_synthesis"], "synthesis", everything=everything)
    angles = pressure_document(run.results["cam_pressure"], "pressure angle", everything=everything)
    table = angles.table if form is Format.csv else None
    job.finish(Document(heading, table=table, parts=(found, angles)), run, form)
