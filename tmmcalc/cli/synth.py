"""``tmmcalc synth``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.found import Force, SpecOut, Target
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Columns, Form, Format, patterns_of
from tmmcalc.cli.output import title

if TYPE_CHECKING:
    from tmmcalc.project import Spec


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
            help="Solution N, from 1, to print and write (default: that of the spec, or the best that keeps its "
            "[[constraints]]).",
            show_default=False,
        ),
    ] = None,
    spec_out: SpecOut = None,
    force: Force = False,
) -> None:
    """Synthesis of a linkage: all solutions, the best first, each simulated and checked against what was asked.

    --spec writes the spec with the solution as a whole [mechanism] in the place of [synthesis]. [[constraints]] judge
    every solution: the first that keeps them is chosen; if none does, the nearest, with a warning of what fails.

    Example: tmmcalc synth my.toml --spec ready.toml
    """
    patterns = patterns_of(columns)
    Target(job.file, spec_out, force).check()
    scene = job.spec()
    run = job.run(scene, "feasibility" if scene.constraints and _is_alone(scene) else "synthesis")
    result, judged = run.results["synthesis"], run.results.get("feasibility")
    if choose is None:
        choose = (scene.synthesis and scene.synthesis.choose) or (1 if judged is None else judged.chosen)
    from tmmcalc.linkage.facts.synthesis import document as synthesis_document
    from tmmcalc.report.rows import check_choice

    check_choice(choose, len(result.designs), "solution")
    target = Target(job.file, spec_out, force, choose)
    settled = target.made(scene, "synthesis", result)

    heading = title(scene, job.file, "synthesis")
    everything = form is not Format.table
    document = synthesis_document(result, heading, choose=choose, patterns=patterns, everything=everything)
    if judged is not None:
        from tmmcalc.feasibility.facts.feasibility import candidates_document

        document = replace(document, parts=(candidates_document(judged, "constraints", choose),))
    job.finish(document, run, form)
    target.write(settled, job.quiet)


def _is_alone(scene: Spec) -> bool:
    """Whether the spec is about the solutions, so that its constraints are; else they are on the machine of one."""
    from tmmcalc.pipeline.settling import settling
    from tmmcalc.rooms import STAGES

    return settling(scene, None, STAGES) is None
