"""``tmmcalc stress``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Form, Format, Quiet, Set, printed, stages
from tmmcalc.cli.output import check_apart, check_picture, check_place, deliver
from tmmcalc.core.errors import UsageError
from tmmcalc.core.printable import printable

if TYPE_CHECKING:
    from tmmcalc.report.document import Document
    from tmmcalc.stress.results import Stress


def _ladders(incomplete: str) -> list[str]:
    """Ladders that begin so, for the completion of the shell."""
    from tmmcalc.stress.ladders import LADDERS

    return [name for name in LADDERS if name.startswith(incomplete)]


def command(
    spec: Annotated[
        Path | None,
        typer.Argument(
            help="Project spec (TOML); without it the extreme scenes that come with the program.",
            metavar="[SPEC]",
            show_default=False,
        ),
    ] = None,
    ladder: Annotated[
        list[str] | None,
        typer.Option(
            "--ladder",
            metavar="NAME",
            help="Climb this ladder; may be repeated (default: every one that the scene has).",
            show_default=False,
            autocompletion=_ladders,
        ),
    ] = None,
    stage: Annotated[
        str | None,
        typer.Option(
            "--stage",
            metavar="STAGE",
            help="Run up to this stage (default: every stage of the spec).",
            show_default=False,
            autocompletion=stages,
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot",
            metavar="FILE",
            help="Error over condition number, a panel a ladder, by suffix svg, png or pdf.",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="Write the tables to this file, print nothing (-: print them).",
            show_default=False,
            callback=printed,
        ),
    ] = None,
    form: Form = Format.table,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Drive a scene toward its extremes, and tell where its digits go.

    Every rung of a ladder is run beside an equivalent scene: in other units, mirrored, begun elsewhere, on another
    grid. Their largest relative difference stands beside the condition number and the stage's own estimate.
    A ladder that the scene has not is left out with the reason. No stage files are read or written.
    A result that the equivalent scene refuses, and that no warning comes with, is disputed.
    Of scenes with motions in time, a search or groups beyond dyads every fourth rung is climbed, all of named ladders.

    Exit code 1 if the program itself fails on a rung, or a shipped scene misses its known answer.

    Example: tmmcalc stress my.toml --ladder dead-point --plot stress.svg
    """
    _check(plot, out)
    with _progress(quiet) as telling:
        result = _solved(spec, ladder or [], stage, overrides or [], telling)
    heading = printable(f"{spec.stem if spec else 'extreme scenes'}: stress")
    deliver(_document(result, heading, form), form, out)
    if plot is not None:
        from tmmcalc.report.drawing import draw
        from tmmcalc.stress.picture import stress_drawing

        draw(plot, lambda: stress_drawing(result, heading))
    for file in (out, plot):
        if file is not None and not quiet:
            note_written(file)
    if result.faults:
        raise typer.Exit(1)


def _check(plot: Path | None, out: Path | None) -> None:
    """Refuse what would only come out after the computation."""
    if out is not None:
        check_place(out, "-o")
    if plot is not None:
        check_picture(plot, "--plot")
    check_apart(out, plot)


@contextmanager
def _progress(quiet: bool) -> Iterator[Callable[[str, str], None] | None]:
    if quiet or not sys.stderr.isatty():
        yield None
        return
    from tmmcalc.cli.progress import described

    with described() as told:
        yield lambda ladder, rung: told(f"{ladder}: {rung}")


def _document(result: Stress, heading: str, form: Format) -> Document:
    from tmmcalc.stress.document import stress_document, tidy_stress

    return tidy_stress(result, heading) if form is Format.csv else stress_document(result, heading)


def _solved(
    spec: Path | None,
    ladders: list[str],
    stage: str | None,
    overrides: list[str],
    telling: Callable[[str, str], None] | None,
) -> Stress:
    if spec is None:
        if ladders or stage or overrides:
            raise UsageError(
                "no spec is named", where="stress", remedy="write e.g. tmmcalc stress my.toml --ladder scale"
            )
        from tmmcalc.stress.shipped import solve_shipped

        return solve_shipped(telling)
    from tmmcalc.project.loader import Variants, read_text
    from tmmcalc.stress.run import solve_stress

    return solve_stress(Variants(read_text(spec), str(spec), spec.parent, overrides), ladders, stage, telling)
