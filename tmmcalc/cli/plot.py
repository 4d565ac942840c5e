"""``tmmcalc plot``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import say
from tmmcalc.cli.options import Quiet, Set, SpecFile
from tmmcalc.cli.work import Job
from tmmcalc.errors import UsageError

DRAWN = ("kinematics",)


def command(
    spec: SpecFile,
    stage: Annotated[str, typer.Argument(help=f"Stage to draw: {', '.join(DRAWN)}.")] = "kinematics",
    out: Annotated[
        Path | None,
        typer.Option(
            "-o", "--out", help="Picture, by suffix svg, png or pdf (default: <spec>.svg).", show_default=False
        ),
    ] = None,
    positions: Annotated[
        str | None,
        typer.Option("--positions", metavar="LIST", help="Positions to draw, the first with main lines: '7,0:24:2'."),
    ] = None,
    polygons: Annotated[
        str | None,
        typer.Option("--polygons", metavar="POSITION", help="Add the velocity and acceleration polygons there."),
    ] = None,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Draw the scheme in the chosen positions with the paths of its points, and the diagrams of the outputs.

    Example: tmmcalc plot configs/shaper.toml kinematics -o shaper.svg --polygons 21
    """
    if stage not in DRAWN:
        raise UsageError(f"there is no picture of {stage!r}", where="plot", remedy=f"pictures: {', '.join(DRAWN)}")
    from tmmcalc.cli.kinematics import rows_of
    from tmmcalc.report.pictures import draw_kinematics
    from tmmcalc.spec.linkage import to_linkage

    job = Job(spec, store=False, quiet=True, overrides=overrides or ())
    scene = job.spec()
    result = job.run(scene, "kinematics").results["kinematics"]
    file = out or Path(f"{spec.stem}.svg")
    chosen = rows_of(positions, result.labels)
    marked = rows_of(polygons, result.labels)
    draw_kinematics(to_linkage(scene.mechanism), result, file, positions=chosen, polygons=marked[0] if marked else None)
    if not quiet:
        say(f"wrote {file}")
