"""``tmmcalc synth``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Columns, Form, Format, patterns_of
from tmmcalc.cli.output import check_place, title
from tmmcalc.core.errors import UsageError


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    choose: Annotated[
        int | None,
        typer.Option(
            "--choose",
            metavar="N",
            min=1,
            help="Solution to print and write (default: 1, of a spec with [[constraints]] the first that keeps them).",
            show_default=False,
        ),
    ] = None,
    ready: Annotated[
        Path | None,
        typer.Option("--spec", metavar="FILE", help="Write the ready spec of the solution.", show_default=False),
    ] = None,
) -> None:
    """Synthesis of a linkage: all solutions, the best first, each simulated and checked against what was asked.

    The ready spec is a whole [mechanism] that check, kinematics and plot run. [[constraints]] judge every solution:
    the first that keeps them is chosen; if none does, the nearest, with a warning of what fails.

    Example: tmmcalc synth my.toml --spec ready.toml
    """
    patterns = patterns_of(columns)
    if ready is not None:
        check_place(ready, "--spec")
    scene = job.spec()
    run = job.run(scene, "feasibility" if scene.constraints else "synthesis")
    result, judged = run.results["synthesis"], run.results.get("feasibility")
    if choose is None:
        choose = 1 if judged is None else judged.chosen
    if choose > len(result.designs):
        count = len(result.designs)
        raise UsageError(
            f"there is no solution {choose}", where="--choose", value=choose, limit=count, remedy=f"write 1 to {count}"
        )
    from tmmcalc.linkage.facts.synthesis import document as synthesis_document

    heading = title(scene, job.file, "synthesis")
    everything = form is not Format.table
    document = synthesis_document(result, heading, choose=choose, patterns=patterns, everything=everything)
    if judged is not None:
        from tmmcalc.feasibility.facts.feasibility import candidates_document

        document = replace(document, parts=(candidates_document(judged, "constraints", choose),))
    if ready is not None:
        from tmmcalc.core.atomic import replace_file

        replace_file(ready, result.designs[choose - 1].spec.encode())
    job.finish(document, run, form)
    if ready is not None and not job.quiet:
        note_written(ready)
