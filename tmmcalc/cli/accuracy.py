"""``tmmcalc accuracy``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written, say
from tmmcalc.cli.options import Form, Format, Quiet, Set, SpecFile, printed
from tmmcalc.cli.output import check_apart, check_picture, check_place, check_tolerance, deliver, raise_failures, title

if TYPE_CHECKING:
    from tmmcalc.core.studies.study import Accuracy
    from tmmcalc.report.document import Document


def _subjects(incomplete: str) -> list[str]:
    """Stages with a choice of methods that begin so, for the completion of the shell."""
    from tmmcalc.accuracy.solve import SUBJECTS

    return [name for name in SUBJECTS if name.startswith(incomplete)]


def command(
    spec: SpecFile,
    stage: Annotated[
        str | None,
        typer.Option(
            "--stage",
            metavar="STAGE",
            help="Study this stage alone (default: every stage of the spec that has several methods).",
            show_default=False,
            autocompletion=_subjects,
        ),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(
            "--tolerance",
            metavar="ERROR",
            help="Name the cheapest method for this relative error (default: for 1e-3, 1e-6, 1e-9, 1e-12).",
            show_default=False,
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot", metavar="FILE", help="Work-precision diagram, by suffix svg, png or pdf.", show_default=False
        ),
    ] = None,
    repeats: Annotated[
        int, typer.Option("--repeats", metavar="N", min=1, max=1000, help="Runs that a median time is taken of.")
    ] = 7,
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
    """Error against run time: every method of the stages, beside a reference and its own error.

    Errors are the largest over all positions, relative to the largest magnitude of the quantity; times are medians.
    The order is that observed: error ~ step^order. The cheapest setting is the fastest that keeps a tolerance and whose
    finer ones keep it too. No stage files are read or written. A stage without a solution ends only the study of those
    that read it.

    Example: tmmcalc accuracy my.toml --stage motion --plot motion.svg
    """
    if tolerance is not None:
        check_tolerance(tolerance)
    if out is not None:
        check_place(out, "-o")
    if plot is not None:
        check_picture(plot, "--plot")
    check_apart(out, plot)
    from tmmcalc.accuracy.solve import solve_accuracy
    from tmmcalc.core.studies.measure import Clock

    scene = Job(spec, overrides=overrides or ()).spec()
    telling = not quiet and sys.stderr.isatty()
    result = solve_accuracy(scene, stage, Clock(repeats), (lambda words: say(words, "dim")) if telling else None)
    heading = title(scene, spec, "accuracy")
    deliver(_document(result, heading, form, tolerance), form, out)
    drawn = plot if result.studies or result.ladders else None
    if drawn is not None:
        from tmmcalc.accuracy.picture import accuracy_drawing
        from tmmcalc.report.drawing import draw

        draw(drawn, lambda: accuracy_drawing(result, heading, tolerance))
    elif plot is not None:
        say("no stage of this scene has a choice of methods: there is nothing to draw", "yellow")
    for file in (out, drawn):
        if file is not None and not quiet:
            note_written(file)
    raise_failures(result.failures)


def _document(result: Accuracy, heading: str, form: Format, tolerance: float | None) -> Document:
    from tmmcalc.accuracy.document import accuracy_document, tidy_document

    document = tidy_document if form is Format.csv else accuracy_document
    return document(result, heading, tolerance)
