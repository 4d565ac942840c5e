"""``tmmcalc note``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Fresh, Language, Quiet, Set, SpecFile, Store, spoken_in
from tmmcalc.report.drawing.order import POSITIONS

STDOUT = Path("-")


def command(
    spec: SpecFile,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="The note, by suffix pdf, docx, html, typ (for Typst) or txt; '-' prints it (default: <spec>.pdf).",
            show_default=False,
        ),
    ] = None,
    only: Annotated[
        str | None,
        typer.Option("--only", metavar="LIST", help="These chapters alone: 'kinematics,forces'.", show_default=False),
    ] = None,
    positions: Annotated[
        str | None,
        typer.Option(
            POSITIONS,
            metavar="LIST",
            help="Positions with their numbers: '3,9' (default: one of the working and one of the idle stroke).",
            show_default=False,
        ),
    ] = None,
    depth: Annotated[
        str | None,
        typer.Option(
            "--depth",
            metavar="DEPTH",
            help="full, short (each formula with one set of numbers) or answers (tables of results); default: full.",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
    store: Store = True,
    fresh: Fresh = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Write the note: every formula in letters, then with the numbers of the chosen positions, and its value.

    Each line is worked out again with its printed numbers; one that does not give its printed result is an error of the
    program. What [note] in the spec says holds unless a flag says otherwise; texts of your own stand in a folder note
    beside it: introduction.md, conclusions.md, kinematics.md and so on.

    Example: tmmcalc note my.toml -o my.pdf --positions 3,9 --language uk
    """
    from tmmcalc.note.forms import check_form, formed
    from tmmcalc.note.made import frame_of, note_of, told_in
    from tmmcalc.pipeline.chapters import stages_of
    from tmmcalc.report.language import speaking
    from tmmcalc.report.printing import printing
    from tmmcalc.report.tables.note import NoteTable

    file = out or Path(f"{spec.stem}.pdf")
    form = "txt" if file == STDOUT else file.suffix.lower().removeprefix(".")
    check_form(form)
    job = Job(spec, store=store, fresh=fresh, quiet=quiet, overrides=overrides or (), csv=False)
    scene = job.spec()
    said = scene.note or NoteTable()
    titles = told_in(only.split(",") if only is not None else said.chapters)
    with speaking(spoken_in(scene, language)), printing(said.units):
        run = job.run(scene, stages_of([*titles]))
        note = note_of(scene, run, titles, spec.parent, positions=positions, depth=depth, alone=only is not None)
        written = formed(note, form, scene.project.title, frame_of(scene))
    if file == STDOUT:
        sys.stdout.buffer.write(written)
        return
    from tmmcalc.core.atomic import replace_file

    replace_file(file, written)
    if not quiet:
        note_written(file)
