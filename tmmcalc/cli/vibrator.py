"""``tmmcalc vibrator``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, patterns_of
from tmmcalc.cli.work import Job, title


@with_flags
def command(job: Job, form: Form = Format.table, columns: Columns = None) -> None:
    """Vibratory assembly device: stiffnesses, natural frequencies and modes, resonance curve, steady motion, starts.

    A start by the motor tells whether the rotor passes its resonances or stays at one. The table shows the modes and
    some rows of the starts; --format csv, json or toml prints everything in SI.

    Example: tmmcalc vibrator my.toml --columns 't,omega,x,tilt_*'
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "vibrator")
    from tmmcalc.vibration.facts.vibrator import document as vibrator_document

    heading = title(scene, job.file, "vibratory device")
    everything = form is not Format.table
    job.finish(vibrator_document(run.results["vibrator"], heading, patterns=patterns, everything=everything), run, form)
