"""``tmmcalc gears planetary``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    choose: Annotated[
        int,
        typer.Option("--choose", metavar="N", min=1, help="Of a [train]: which tooth set, as gears synth lists them."),
    ] = 1,
    power: Annotated[bool, typer.Option("--power/--kinematic", help="Of a [train]: what the drive is for.")] = True,
    internal: Annotated[
        bool, typer.Option("--internal/--external", help="Of a [train]: whether internal wheels can be cut.")
    ] = True,
) -> None:
    """Any train: exact ratios, speeds, torques, power flow, efficiency both ways.

    Of a [gearing] all of it. Of a [train] the types that suit its ratio, how many planets go in, and the motion of
    one of its tooth sets.

    Example: tmmcalc gears planetary my.toml --choose 2
    """
    scene = job.spec()
    if scene.gearing is None and scene.train is None:
        raise UsageError(
            "the spec has neither [gearing] nor [train]",
            where="gears planetary",
            remedy="write the train out in [gearing], or ask for tooth numbers in [train]",
        )
    run = job.run(scene, "gearing" if scene.gearing is not None else "train")
    job.finish(_printed(run, scene, title(scene, job.file, "gears"), choose, power, internal, form), run, form)


def _printed(
    run: RunResult, scene: Spec, heading: str, choose: int, power: bool, internal: bool, form: Format
) -> Document:
    if scene.gearing is not None:
        from tmmcalc.gears.facts.gearing import document as gearing_document

        return gearing_document(run.results["gearing"], heading)
    from tmmcalc.gears.facts.planetary import planetary_document

    assert scene.train is not None
    speed = scene.train.input_speed
    asked = {"power": power, "internal": internal, "everything": form is not Format.table}
    return planetary_document(run.results["train"], heading, speed, choose=choose, **asked)
