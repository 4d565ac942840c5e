"""``tmmcalc plan``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.options import Form, Format, Set, SpecFile, stages
from tmmcalc.cli.work import Job, show, title


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
    form: Form = Format.table,
    overrides: Set = None,
) -> None:
    """Which stages run for this spec and target, which are left out, and why. Nothing is computed.

    Example: tmmcalc plan my.toml kinematics
    """
    from tmmcalc.pipeline.plan import plan
    from tmmcalc.report.document import Document, View

    scene = Job(spec, overrides=overrides or ()).spec()
    steps = plan(scene, target).steps
    view = View(
        ["stage", "runs", "why", "gives"],
        [
            [s.stage for s in steps],
            ["yes" if s.runs else "no" for s in steps],
            [s.reason for s in steps],
            [s.title for s in steps],
        ],
    )
    show(Document(title(scene, spec, "plan"), table=view), form)
