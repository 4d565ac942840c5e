"""``tmmcalc plot``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.drawings import DRAWINGS, drawing_of
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Quiet, Set, SpecFile
from tmmcalc.cli.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.cli.work import Job, check_place

WIDTH = 78  # of the list of pictures, which the help indents by two


def _drawn(incomplete: str) -> list[str]:
    """Stages with a picture that begin so, for the completion of the shell."""
    return [name for name in DRAWINGS if name.startswith(incomplete)]


def command(
    spec: SpecFile,
    stage: Annotated[
        str,
        typer.Argument(help="Stage to draw, one of those above.", metavar="STAGE", autocompletion=_drawn),
    ] = "kinematics",
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
        typer.Option(POSITIONS, metavar="LIST", help="Positions of the scheme, the first bold: '7,0:24:2'."),
    ] = None,
    polygons: Annotated[
        str | None,
        typer.Option(POLYGONS, metavar="POSITION", help="Add the polygons of velocities, or of forces, there."),
    ] = None,
    choose: Annotated[
        int | None,
        typer.Option(
            CHOOSE,
            metavar="N",
            min=1,
            help="Train or pair to draw, from 1: of train set N as gears synth lists them, of criteria row N of "
            "criteria.csv, of synthesis solution N, of pair, blocking and profile pair N (default: all).",
            show_default=False,
        ),
    ] = None,
    phase: Annotated[
        str | None,
        typer.Option(
            PHASE,
            metavar="ANGLE",
            help="Turn of the pinion from the contact at P, of indexing cams from the step: '10 deg'.",
        ),
    ] = None,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Draw the result of a stage; it is computed afresh, no stage files are read or written."""
    flags = {POSITIONS: positions, POLYGONS: polygons, CHOOSE: None if choose is None else str(choose), PHASE: phase}
    drawing = drawing_of(stage, flags)
    file = out or Path(f"{spec.stem}.svg")
    check_place(file, "plot")
    job = Job(spec, store=False, quiet=True, overrides=overrides or ())
    scene = job.spec()
    drawing.draw(Order(scene, job.run(scene, stage).results, file, flags))
    if not quiet:
        note_written(file)


def _list() -> str:
    """What the picture of every stage shows, a paragraph that the help leaves as it is."""
    from textwrap import wrap

    longest = max(map(len, DRAWINGS)) + 2
    lines = []
    for name, drawing in DRAWINGS.items():
        lines += wrap(f"{name:<{longest}}{drawing.shows}", WIDTH, subsequent_indent=" " * longest)
    return "\n".join(["\b", *lines])


command.__doc__ = f"""{command.__doc__}

{_list()}

Example: tmmcalc plot my.toml kinematics -o my.svg --polygons 6
"""
