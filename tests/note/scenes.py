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
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.project.found import text_of
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.language import spoken
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


@cache
def solved(name: str, only: tuple[str, ...], changed: tuple[str, ...] = ()) -> RunResult:
    """What the chapters of these rooms are made of, once for all tests: it has no language."""
    return run(load_spec(CONFIGS / f"{name}.toml", changed), target=stages_of(only))


def told(
    name: str, positions: str | None = None, only: Sequence[str] = tuple(CHAPTERS), changed: Sequence[str] = ()
) -> list[Chapter]:
    """The chapters of a ready spec, with these keys changed, in the language in force."""
    return list(_told(name, positions, tuple(only), tuple(changed), spoken()))


@cache
def _told(
    name: str, positions: str | None, only: tuple[str, ...], changed: tuple[str, ...], language: str
) -> tuple[Chapter, ...]:
    """Once for all tests in a language, which is the one in force."""
    done = solved(name, only, changed)
    titles = {chapter: CHAPTERS[chapter] for chapter in only}
    return tuple(chapters_of(titles, done.spec, done.results, {**NONE, POSITIONS: positions}))


def blocks(told: list[Chapter]) -> list[Block]:
    """What stands in these chapters."""
    return [block for chapter in told for block in chapter.blocks]


def lines(name: str) -> list[Checked]:
    """The lines of a note, worked out."""
    assembler = Assembler()
    assembler.written(chapters(name))
    return assembler.lines


def written(name: str, only: Sequence[str] = tuple(CHAPTERS), depth: str = FULL) -> list[Written]:
    """The whole note in the language in force."""
    return list(_written(name, tuple(only), depth, spoken()))


@cache
def _written(name: str, only: tuple[str, ...], depth: str, language: str) -> tuple[Written, ...]:
    """Once for all tests in a language, which is the one in force."""
    done, stages = solved(name, only), stages_of(only)
    chapters = chapters_of({chapter: CHAPTERS[chapter] for chapter in only}, done.spec, done.results)
    task, sought = task_of(done.spec, done.results), sought_in(done.results, stages)
    warnings, errors = warnings_of(done, stages), errors_of(done, stages)
    given = text_of(load_spec(CONFIGS / f"{name}.toml"))
    return tuple(whole(Work(name, AuthorTable(), {}, warnings, errors, given, task, sought), chapters, depth))
