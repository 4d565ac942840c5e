"""The note of a run: what the pipeline tells of its stages as the spec wants it told, in the language in force."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.own import own_texts
from tmmcalc.note.whole import Work, whole
from tmmcalc.pipeline.chapters import chapters_of, errors_of, sought_in, stages_of, task_of, warnings_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.project.found import text_of
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.sheets.gosttext import TextTitles
from tmmcalc.report.tables.note import NoteTable

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.note.tree import Written
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.tables.note import AuthorTable


def told_in(names: Sequence[str]) -> Mapping[str, str]:
    """The titles of these chapters, of all without a name; raises `UsageError` for others."""
    from tmmcalc.rooms import CHAPTERS

    asked = [each.strip() for each in names]
    for name in asked:
        if name not in CHAPTERS:
            raise UsageError(f"there is no chapter {name!r}", where="--only", remedy=f"chapters: {', '.join(CHAPTERS)}")
    return {name: title for name, title in CHAPTERS.items() if name in asked} if asked else CHAPTERS


def note_of(
    scene: Spec,
    run: RunResult,
    titles: Mapping[str, str],
    folder: Path,
    *,
    positions: str | None = None,
    depth: str | None = None,
    alone: bool = False,
) -> list[Written]:
    """The note with these chapters; ``alone``: nothing but them. ``folder`` is that of the spec, beside which own
    texts stand. Raises `UsageError` where the scene has nothing for them."""
    said = scene.note or NoteTable()
    stages = stages_of([*titles])
    flags: dict[str, str | None] = {**NONE, POSITIONS: positions or ",".join(said.positions) or None}
    own = own_texts(folder / said.texts, titles)
    with run.believed():
        chapters = chapters_of(titles, run.spec, run.results, flags)
        if not chapters:
            nothing = f"the scene has nothing for these chapters: {', '.join(titles)}"
            raise UsageError(nothing, where="note", remedy="see tmmcalc plan")
        if alone:
            return Assembler(depth or said.depth).written(chapters)
        work = Work(
            scene.project.title,
            who_of(scene),
            own,
            warnings_of(run, stages),
            errors_of(run, stages),
            text_of(scene),
            task_of(run.spec, run.results, flags),
            sought_in(run.results, stages),
        )
        return whole(work, chapters, depth or said.depth)


def who_of(scene: Spec) -> AuthorTable:
    """Who stands on the title page: by [note.who], else by [sheets.who]."""
    said = scene.note or NoteTable()
    if scene.sheets is None:
        return said.who
    block = scene.sheets.who
    usual = {"organisation": [block.organisation] if block.organisation else [], "done_by": block.drawn_by}
    usual |= {"checked_by": block.checked_by}
    return said.who.model_copy(update={key: value for key, value in usual.items() if not getattr(said.who, key)})


def frame_of(scene: Spec) -> TextTitles | None:
    """What stands in the frames of the pages; None without frames."""
    said = scene.note or NoteTable()
    if said.frame == "none":
        return None
    who = who_of(scene)
    at = ", ".join([*who.organisation[-1:], *([who.group] if who.group else [])])
    return TextTitles(scene.project.title, who.designation, who.done_by, who.checked_by, at)
