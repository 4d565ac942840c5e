"""``tmmcalc note``."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Fresh, Language, Quiet, Set, SpecFile, Store, language_of
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.order import POSITIONS

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

FORMS = {"pdf": "typst", "docx": "docx", "html": "", "typ": "", "txt": ""}  # and the package that each needs
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
    language: Language = None,
    store: Store = True,
    fresh: Fresh = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Write the note: every formula in letters, then with the numbers of the chosen positions, and its value.

    Each line is worked out again with its printed numbers; one that does not give its printed result is an error of the
    program.

    Example: tmmcalc note my.toml -o my.pdf --positions 3,9 --language uk
    """
    from tmmcalc.pipeline.chapters import stages_of
    from tmmcalc.report.language import speaking

    file = out or Path(f"{spec.stem}.pdf")
    form = "txt" if file == STDOUT else _form(file)
    titles = _chosen(only)
    job = Job(spec, store=store, fresh=fresh, quiet=quiet, overrides=overrides or (), csv=False)
    scene = job.spec()
    with speaking(language_of(scene, language)):
        run = job.run(scene, stages_of([*titles]))
        written = _written(run, titles, positions, form)
    if file == STDOUT:
        sys.stdout.buffer.write(written)
        return
    from tmmcalc.core.atomic import replace_file

    replace_file(file, written)
    if not quiet:
        note_written(file)


def _form(file: Path) -> str:
    """The form that the suffix names; raises `UsageError` for another, and for a missing package."""
    form = file.suffix.lower().removeprefix(".")
    if form not in FORMS:
        remedy = f"forms: {', '.join(FORMS)}"
        raise UsageError(f"no form of a note for the suffix {file.suffix!r} of {file.name}", where="-o", remedy=remedy)
    package = FORMS[form]
    if package:
        from importlib.util import find_spec

        if find_spec(package) is None:
            from tmmcalc.core.installation import install

            said = f"a note as {form} needs {package}, which is not installed"
            raise UsageError(said, where="-o", remedy=f"{install('note')}; html and txt need nothing")
    return form


def _chosen(only: str | None) -> dict[str, str]:
    """The titles of all chapters, or of those that are asked for; raises `UsageError` for others."""
    from tmmcalc.rooms import CHAPTERS

    if only is None:
        return CHAPTERS
    asked = [each.strip() for each in only.split(",")]
    for name in asked:
        if name not in CHAPTERS:
            raise UsageError(f"there is no chapter {name!r}", where="--only", remedy=f"chapters: {', '.join(CHAPTERS)}")
    return {name: title for name, title in CHAPTERS.items() if name in asked}


def _written(run: RunResult, titles: Mapping[str, str], positions: str | None, form: str) -> bytes:
    from tmmcalc.note.assembled import Assembler
    from tmmcalc.pipeline.chapters import chapters_of
    from tmmcalc.pipeline.picturing import NONE
    from tmmcalc.report.language import spoken

    chapters = chapters_of(titles, run.spec, run.results, {**NONE, POSITIONS: positions})
    if not chapters:
        said = f"the scene has nothing for these chapters: {', '.join(titles)}"
        raise UsageError(said, where="note", remedy="see tmmcalc plan")
    note = Assembler().written(chapters)
    if form == "txt":
        from tmmcalc.note.plaintext import text

        return text(note).encode()
    title = run.spec.project.title
    if form == "html":
        from tmmcalc.note.html import page

        return page(note, title, spoken()).encode()
    if form == "docx":
        from tmmcalc.note.docx import document

        return document(note, title)
    from tmmcalc.note.typst import pdf, source

    typed = source(note, spoken())
    return typed.encode() if form == "typ" else pdf(typed)
