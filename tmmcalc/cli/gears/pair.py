"""``tmmcalc gears pair``."""

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
    """Pairs of gears: shifts, centre distance, radii, contact ratios, sliding; every condition with its margin.

    Of a [train] every mesh of the tooth set that was chosen. The table shows the radii; --format csv prints the
    sliding along the line of action, json and toml all of it.

    Example: tmmcalc gears pair my.toml --pair 1-2
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "pair")
    from tmmcalc.report.pair import chosen_pairs, pair_document

    result, heading = chosen_pairs(run.results["pair"], pair), title(scene, spec, "pairs of gears")
    job.finish(pair_document(result, heading, everything=form is not Format.table), run, form)
