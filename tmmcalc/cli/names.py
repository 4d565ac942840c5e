"""``tmmcalc names``."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title


@with_flags
def command(
    job: Job,
    patterns: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PATTERN]...",
            help="Names, with wildcards: 'motion.*', 'R_?', 'forces.max(R_*)', 'kinematics.vS_D[phi=45 deg]' "
            "(default: all).",
            show_default=False,
        ),
    ] = None,
    form: Form = Format.table,
) -> None:
    """What a scene can tell, by name: symbol, unit, value and meaning of every fact, extremes of every column.

    These are the names of `sweep --columns` and of `[[constraints]]`. A column is asked for extremes, max(R_A), where
    they are, at_max(R_A), or a place, R_A@6, R_A[phi=45 deg]. What is by choice has a value when its name is asked for.
    All stages are run, or loaded from their files.

    Example: tmmcalc names my.toml 'forces.max(R_*)' motion.delta
    """
    from tmmcalc.batch.names import names_document
    from tmmcalc.naming.language import parse

    for pattern in patterns or ():
        parse(pattern)  # a slip is told before anything is computed
    scene = job.spec()
    result = replace(job, keep_going=True).run(scene, None)
    with job.believed():
        document = names_document(result, patterns or (), title(scene, job.file, "names"), form is Format.table)
    job.finish(document, result, form)
