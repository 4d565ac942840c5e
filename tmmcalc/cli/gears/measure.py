"""``tmmcalc gears measure``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.gears.drawn import length_of
from tmmcalc.cli.gears.known import Row, check_pair, of_pairs, of_wheel
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    pair: Annotated[
        str | None,
        typer.Option("--pair", metavar="NAME", help="This pair alone, where there are several.", show_default=False),
    ] = None,
    choose: Row = None,
    wheel: Annotated[
        str | None, typer.Option("--wheel", metavar="NAME", help="This wheel alone.", show_default=False)
    ] = None,
    teeth: Annotated[
        int | None, typer.Option("--teeth", metavar="N", min=2, help="The span over N teeth.", show_default=False)
    ] = None,
    ball: Annotated[
        str | None,
        typer.Option("--ball", metavar="LENGTH", help="Balls or pins of this diameter: '8.5 mm'.", show_default=False),
    ] = None,
    radius: Annotated[
        list[str] | None,
        typer.Option(
            "--radius", metavar="LENGTH", help="The tooth on this circle, repeatable: '67 mm'.", show_default=False
        ),
    ] = None,
) -> None:
    """What is measured on the wheels: span over teeth, size over balls or pins, chords, with the limits of each.

    A [wheel] without a mate is measured where the spec has no pairs. Spans are judged by the textbook's rule and
    exactly. --format csv prints the spans of all wheels.

    Example: tmmcalc gears measure my.toml --wheel 1 --teeth 3 --ball '8.5 mm' --radius '67 mm'
    """
    diameter = None if ball is None else length_of(ball, "--ball", "8.5 mm")
    radii = [length_of(text, "--radius", "67 mm") for text in radius or ()]
    scene = job.spec()
    if of_wheel(scene, choose, pair, wheel):
        run = job.run(scene, "wheel")
        from tmmcalc.gears.facts.wheel import measures_of
        from tmmcalc.gears.meshing.remeasure import remeasured_wheel

        single = remeasured_wheel(run.results["wheel"], teeth, diameter, radii)
        heading, everything = title(scene, job.file, "measures of a wheel"), form is not Format.table
        job.finish(measures_of(single, heading, everything=everything), run, form)
        return
    job, scene = of_pairs(job, scene, choose)
    check_pair(scene, pair)
    run = job.run(scene, "pair")
    from tmmcalc.gears.facts.measure import measure_document
    from tmmcalc.gears.facts.pair import chosen_pairs
    from tmmcalc.gears.meshing.remeasure import remeasured

    result, heading = chosen_pairs(run.results["pair"], pair), title(scene, job.file, "measures of gears")
    if teeth is not None or diameter is not None or radii:
        result = remeasured(result, teeth, diameter, radii)
    job.finish(measure_document(result, heading, wheel=wheel, everything=form is not Format.table), run, form)
