"""``tmmcalc plan``."""

from __future__ import annotations

from dataclasses import replace
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
    from tmmcalc.pipeline.documents import plan_document
    from tmmcalc.pipeline.settling import outlook, planned, settling
    from tmmcalc.rooms import STAGES, TABLES

    scene = Job(spec, overrides=overrides or ()).spec()
    found = planned(scene, target, STAGES, skip or ())
    notes: tuple[str, ...] = ()
    supposed: tuple[str, ...] = ()
    if (first := settling(scene, target, STAGES, skip or ())) is not None:
        scene = outlook(scene, target, STAGES, skip or ())
        supposed = (TABLES[first.asked[0]].gives,)
        notes = (f"note: the mechanism is what {first.name} finds; the plan supposes that its crank turns fully",)
    heading = title(scene, spec, "plan")
    if why:
        from tmmcalc.pipeline.why import explain
        from tmmcalc.pipeline.why_document import why_document

        document = why_document(explain(scene, found, supposed=supposed), scene, heading)
    else:
        document = plan_document(found, heading)
    show(replace(document, notes=(*document.notes, *notes)), form)
