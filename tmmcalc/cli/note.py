"""``tmmcalc note``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Fresh, Language, Quiet, Set, SpecFile, Store, language_of
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.order import POSITIONS

if TYPE_CHECKING:
    from tmmcalc.project import Spec
    from tmmcalc.report.sheets.gosttext import TextTitles
    from tmmcalc.report.tables.note import AuthorTable, NoteTable

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
    from tmmcalc.note.assembled import Assembler
    from tmmcalc.note.forms import check_form, formed
    from tmmcalc.note.own import own_texts
    from tmmcalc.note.whole import Work, whole
    from tmmcalc.pipeline.chapters import chapters_of, errors_of, sought_in, stages_of, task_of, warnings_of
    from tmmcalc.project.found import text_of
    from tmmcalc.report.language import speaking
    from tmmcalc.report.printing import printing
    from tmmcalc.report.tables.note import NoteTable

    file = out or Path(f"{spec.stem}.pdf")
    form = "txt" if file == STDOUT else file.suffix.lower().removeprefix(".")
    check_form(form)
    job = Job(spec, store=store, fresh=fresh, quiet=quiet, overrides=overrides or (), csv=False)
    scene = job.spec()
    said = scene.note or NoteTable()
    titles = _chosen(only.split(",") if only is not None else said.chapters)
    stages = stages_of([*titles])
    with speaking(language or said.language or language_of(scene, None)), printing(said.units):
        own = own_texts(spec.parent / said.texts, titles)
        run = job.run(scene, stages)
        with run.believed():
            chapters = chapters_of(titles, run.spec, run.results, _flags(positions, said))
            if not chapters:
                nothing = f"the scene has nothing for these chapters: {', '.join(titles)}"
                raise UsageError(nothing, where="note", remedy="see tmmcalc plan")
            if only is not None:
                note = Assembler(depth or said.depth).written(chapters)
            else:
                warnings, errors = warnings_of(run, stages), errors_of(run, stages)
                task = task_of(run.spec, run.results, _flags(positions, said))
                sought = sought_in(run.results, stages)
                work = Work(scene.project.title, _who(scene, said), own, warnings, errors, text_of(scene), task, sought)
                note = whole(work, chapters, depth or said.depth)
        written = formed(note, form, scene.project.title, _frame(scene, said))
    if file == STDOUT:
        sys.stdout.buffer.write(written)
        return
    from tmmcalc.core.atomic import replace_file

    replace_file(file, written)
    if not quiet:
        note_written(file)


def _chosen(names: Sequence[str]) -> dict[str, str]:
    """The titles of these chapters, of all without a name; raises `UsageError` for others."""
    from tmmcalc.rooms import CHAPTERS

    asked = [each.strip() for each in names]
    for name in asked:
        if name not in CHAPTERS:
            raise UsageError(f"there is no chapter {name!r}", where="--only", remedy=f"chapters: {', '.join(CHAPTERS)}")
    return {name: title for name, title in CHAPTERS.items() if name in asked} if asked else CHAPTERS


def _flags(positions: str | None, said: NoteTable) -> dict[str, str | None]:
    """What the chapters are asked for: the positions of the flag, else those of the spec."""
    from tmmcalc.pipeline.picturing import NONE

    return {**NONE, POSITIONS: positions or ",".join(said.positions) or None}


def _who(scene: Spec, said: NoteTable) -> AuthorTable:
    """Who stands on the title page: by [note.who], else by [sheets.who]."""
    if scene.sheets is None:
        return said.who
    block = scene.sheets.who
    usual = {"organisation": [block.organisation] if block.organisation else [], "done_by": block.drawn_by}
    usual |= {"checked_by": block.checked_by}
    return said.who.model_copy(update={key: value for key, value in usual.items() if not getattr(said.who, key)})


def _frame(scene: Spec, said: NoteTable) -> TextTitles | None:
    """What stands in the frames of the pages; None without frames."""
    if said.frame == "none":
        return None
    from tmmcalc.report.sheets.gosttext import TextTitles

    who = _who(scene, said)
    at = ", ".join([*who.organisation[-1:], *([who.group] if who.group else [])])
    return TextTitles(scene.project.title, who.designation, who.done_by, who.checked_by, at)
