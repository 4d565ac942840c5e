"""``tmmcalc gears blocking``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.options import (
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
)
from tmmcalc.cli.work import Job, title


def command(
    spec: SpecFile,
    form: Form = Format.table,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Blocking contours: which shifts x1, x2 a pair may have, its corners, points of interest, margins of the choice.

    The tables show points and corners; --format csv prints the boundaries, json and toml all of it.

    Example: tmmcalc gears blocking my.toml
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "blocking")
    from tmmcalc.report.blocking import blocking_document, chosen_contours

    result, heading = chosen_contours(run.results["blocking"], pair), title(scene, spec, "blocking contours")
    job.finish(blocking_document(result, heading, everything=form is not Format.table), run, form)
