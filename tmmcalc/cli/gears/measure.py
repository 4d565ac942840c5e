"""``tmmcalc gears measure``."""

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
from tmmcalc.errors import UsageError


def command(
    spec: SpecFile,
    form: Form = Format.table,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
    wheel: Annotated[
        str | None, typer.Option("--wheel", metavar="NAME", help="This wheel alone.", show_default=False)
    ] = None,
    teeth: Annotated[
        int | None, typer.Option("--teeth", metavar="N", min=1, help="The span over N teeth.", show_default=False)
    ] = None,
    ball: Annotated[
        str | None,
        typer.Option("--ball", metavar="LENGTH", help="Balls or pins of this diameter: '8.5 mm'.", show_default=False),
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
    """What is measured on the wheels: span over teeth, size over balls or pins, chords, with the limits of each.

    Spans are judged by the textbook's rule and exactly. --format csv prints the spans of all wheels.

    Example: tmmcalc gears measure my.toml --wheel 1 --teeth 3 --ball '8.5 mm'
    """
    diameter = None if ball is None else _length(ball)
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "pair")
    from tmmcalc.gears.meshing.remeasure import remeasured
    from tmmcalc.report.measure import measure_document
    from tmmcalc.report.pair import chosen_pairs

    result, heading = chosen_pairs(run.results["pair"], pair), title(scene, spec, "measures of gears")
    if teeth is not None or diameter is not None:
        result = remeasured(result, teeth, diameter)
    job.finish(measure_document(result, heading, wheel=wheel, everything=form is not Format.table), run, form)


def _length(text: str) -> float:
    """The length [m] of a flag."""
    from tmmcalc.spec.units import UnitError, parse

    try:
        return parse(text, "length")
    except UnitError as fault:
        raise UsageError(fault.message, where="--ball", remedy=fault.remedy) from None
