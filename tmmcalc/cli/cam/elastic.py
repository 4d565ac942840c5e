"""``tmmcalc cam elastic``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(job: Job, form: Form = Format.table) -> None:
    """Vibration of the follower as one mass on an elastic train: residual after the phases, steady over the turn.

    The table compares laws by what they leave; --format csv prints the motion of the mass over the turn.

    Example: tmmcalc cam elastic my.toml
    """
    scene = job.spec()
    run = job.run(scene, "cam_elastic")
    from tmmcalc.report.cams.elastic import elastic_document

    result, heading = run.results["cam_elastic"], title(scene, job.file, "elastic follower")
    job.finish(elastic_document(result, heading, everything=form is not Format.table), run, form)
