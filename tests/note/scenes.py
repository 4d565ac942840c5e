"""The ready specs, and what their notes say."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from tmmcalc.note.assembled import Assembler, Checked
from tmmcalc.note.tree import Written
from tmmcalc.note.whole import Work, whole
from tmmcalc.pipeline.chapters import chapters_of, errors_of, sought_in, stages_of, task_of, warnings_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.project.found import text_of
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.manuscript import Block, Chapter
from tmmcalc.report.printing import FULL
from tmmcalc.report.tables.note import AuthorTable
from tmmcalc.rooms import CHAPTERS

CONFIGS = Path(__file__).parent.parent.parent / "configs"
SPECS = [file.stem for file in sorted(CONFIGS.glob("*.toml"))]


def linkage(name: str) -> bool:
    """Whether a ready spec has links."""
    found = tomllib.loads((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))
    return bool(found.get("links") or found.get("mechanism", {}).get("links"))


@cache
def chapters(name: str) -> tuple[Chapter, ...]:
    """The chapters of a ready spec in English."""
    return tuple(told(name))


def told(
    name: str, positions: str | None = None, only: tuple[str, ...] = tuple(CHAPTERS), changed: Sequence[str] = ()
) -> list[Chapter]:
    """The chapters of a ready spec, with these keys changed, in the language in force."""
    done = run(load_spec(CONFIGS / f"{name}.toml", changed), target=stages_of(only))
    titles = {chapter: CHAPTERS[chapter] for chapter in only}
    return chapters_of(titles, done.spec, done.results, {**NONE, POSITIONS: positions})


def blocks(told: list[Chapter]) -> list[Block]:
    """What stands in these chapters."""
    return [block for chapter in told for block in chapter.blocks]


def lines(name: str) -> list[Checked]:
    """The lines of a note, worked out."""
    assembler = Assembler()
    assembler.written(chapters(name))
    return assembler.lines


def written(name: str, only: tuple[str, ...] = tuple(CHAPTERS), depth: str = FULL) -> list[Written]:
    """The whole note in the language in force."""
    spec = load_spec(CONFIGS / f"{name}.toml")
    done = run(spec, target=stages_of(only))
    stages, titles = stages_of(only), {chapter: CHAPTERS[chapter] for chapter in only}
    chapters = chapters_of(titles, done.spec, done.results)
    task, sought = task_of(done.spec, done.results), sought_in(done.results, stages)
    warnings, errors = warnings_of(done, stages), errors_of(done, stages)
    work = Work(name, AuthorTable(), {}, warnings, errors, text_of(spec), task, sought)
    return whole(work, chapters, depth)
