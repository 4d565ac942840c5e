"""``tmmcalc plot``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Quiet, Set, SpecFile
from tmmcalc.cli.output import check_place
from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import Picture, arguments, resolve
from tmmcalc.report.drawing import draw
from tmmcalc.report.drawing.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.rooms import STAGES

if TYPE_CHECKING:
    from tmmcalc.project import Spec

WIDTH = 78  # of the list of pictures, which the help indents by two


PICTURES = {name: stage.picture for name, stage in STAGES.items() if stage.picture is not None}


def _drawn(incomplete: str) -> list[str]:
    """Stages with a picture that begin so, for the completion of the shell."""
    return [name for name in PICTURES if name.startswith(incomplete)]


def picture_of(stage: str, flags: Mapping[str, str | None]) -> Picture:
    """The picture of a stage; raises `UsageError` for a stage without one, and for flags that are not its own."""
    if stage not in PICTURES:
        raise UsageError(f"there is no picture of {stage!r}", where="plot", remedy=f"pictures: {', '.join(PICTURES)}")
    picture = PICTURES[stage]
    strange = [flag for flag, value in flags.items() if value is not None and flag not in picture.flags]
    if strange:
        own = f"its own flags: {', '.join(picture.flags)}" if picture.flags else "it has no flags of its own"
        raise UsageError(
            f"{' and '.join(strange)} cannot be used with the picture of {stage}", where="plot", remedy=own
        )
    return picture


def ordered(stage: str, spec: Spec, results: Mapping[str, Any], flags: Mapping[str, str | None], file: Path) -> None:
    """Draw the picture of a stage to a file."""
    from tmmcalc.pipeline.runner import upstream_of
    from tmmcalc.project import parse_spec

    picture = picture_of(stage, flags)

    def solved(name: str) -> Any:
        own = STAGES[name]
        return own.solve(*arguments(own.inputs(spec)), **upstream_of(own, results))

    order = Order(spec, results, flags, solved, parse_spec)
    draw(file, lambda: resolve(picture.figure)(order))


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
    picture_of(stage, flags)
    file = out or Path(f"{spec.stem}.svg")
    check_place(file, "plot")
    job = Job(spec, store=False, quiet=True, overrides=overrides or ())
    scene = job.spec()
    ordered(stage, scene, job.run(scene, stage).results, flags, file)
    if not quiet:
        note_written(file)


def _list() -> str:
    """What the picture of every stage shows, a paragraph that the help leaves as it is."""
    from textwrap import wrap

    longest = max(map(len, PICTURES)) + 2
    lines = []
    for name, picture in PICTURES.items():
        lines += wrap(f"{name:<{longest}}{picture.shows}", WIDTH, subsequent_indent=" " * longest)
    return "\n".join(["\b", *lines])


command.__doc__ = f"""{command.__doc__}

{_list()}

Example: tmmcalc plot my.toml kinematics -o my.svg --polygons 6
"""
