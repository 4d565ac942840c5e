"""``tmmcalc plan``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.options import Form, Format, Set, Skip, SpecFile, stages
from tmmcalc.cli.output import show, title


def command(
    spec: SpecFile,
    target: Annotated[
        str | None,
        typer.Argument(
            metavar="STAGE",
            help="Stage to reach (default: every stage of the spec).",
            show_default=False,
            autocompletion=stages,
        ),
    ] = None,
    why: Annotated[
        bool,
        typer.Option(
            "--why",
            help="Tell of every stage what decided, what would bring it in, who reads it, and what it leaves out.",
        ),
    ] = False,
    skip: Skip = None,
    form: Form = Format.table,
    overrides: Set = None,
) -> None:
    """Which stages run for this spec and target, which are left out, and why. Nothing is computed.

    Example: tmmcalc plan my.toml kinematics --why
    """
    from tmmcalc.core.plan import plan
    from tmmcalc.pipeline.documents import plan_document

    scene = Job(spec, overrides=overrides or ()).spec()
    found = plan(scene, target, skip=skip or ())
    heading = title(scene, spec, "plan")
    if why:
        from tmmcalc.pipeline.why import explain
        from tmmcalc.pipeline.why_document import why_document

        show(why_document(explain(scene, found), scene, heading), form)
    else:
        show(plan_document(found, heading), form)
