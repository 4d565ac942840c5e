"""``tmmcalc plot``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Quiet, Set, SpecFile
from tmmcalc.cli.work import Job, check_place
from tmmcalc.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Sequence

DRAWN = ("kinematics",)


def command(
    spec: SpecFile,
    stage: Annotated[str, typer.Argument(help=f"Stage to draw: {', '.join(DRAWN)}.", metavar="STAGE")] = "kinematics",
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="Picture, by suffix svg, png or pdf (default: <spec>.svg).",
            show_default=False,
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

    The stage is computed afresh; no stage files are read or written.

    Example: tmmcalc plot my.toml kinematics -o my.svg --polygons 6
    """
    if stage not in DRAWN:
        raise UsageError(f"there is no picture of {stage!r}", where="plot", remedy=f"pictures: {', '.join(DRAWN)}")
    from tmmcalc.cli.positions import rows_of
    from tmmcalc.report.pictures import draw_kinematics
    from tmmcalc.spec.linkage import to_linkage

    file = out or Path(f"{spec.stem}.svg")
    check_place(file, "plot")
    job = Job(spec, store=False, quiet=True, overrides=overrides or ())
    scene = job.spec()
    result = job.run(scene, "kinematics").results["kinematics"]
    chosen = rows_of(positions, result.labels)
    marked = _one(polygons, result.labels)
    draw_kinematics(to_linkage(scene.mechanism), result, file, positions=chosen, polygons=marked)
    if not quiet:
        note_written(file)


def _one(position: str | None, labels: Sequence[str]) -> int | None:
    """The index of one position."""
    from tmmcalc.cli.positions import rows_of

    rows = rows_of(position, labels, "--polygons")
    if rows is not None and len(rows) > 1:
        raise UsageError(f"{position!r} names {len(rows)} positions", where="--polygons", remedy="name one of them")
    return rows[0] if rows else None
