"""``tmmcalc pendulum``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, patterns_of
from tmmcalc.cli.work import Job, title


@with_flags
def command(job: Job, form: Form = Format.table, columns: Columns = None) -> None:
    """Pendulum-rotor: natural frequencies and whirl, critical speeds, torsion, Campbell diagram, motion in time.

    The table shows the modes and some rows of diagram and motion; --format csv, json or toml prints everything in SI.

    Example: tmmcalc pendulum my.toml --set pendulum.spin="'900 rpm'"
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "pendulum")
    from tmmcalc.vibration.facts.pendulum import document as pendulum_document

    heading = title(scene, job.file, "pendulum-rotor")
    everything = form is not Format.table
    job.finish(pendulum_document(run.results["pendulum"], heading, patterns=patterns, everything=everything), run, form)
