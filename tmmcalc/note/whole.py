"""The whole note in its order: title page, contents, what the person wrote, chapters, conclusions, appendix."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from tmmcalc.note.appendix import appendix
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.conclusions import conclusions
from tmmcalc.note.task import task
from tmmcalc.note.tree import Contents, Cover, Title, Written
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Chapter
from tmmcalc.report.tables.note import AuthorTable

CONTENTS = 2  # levels of titles in the contents


class Work(NamedTuple):
    """What a note is made from, beside its chapters."""

    title: str
    who: AuthorTable
    own: Mapping[str, tuple[Block, ...]]  # texts of the person by part or chapter
    warnings: Sequence[str]
    errors: Mapping[str, Mapping[str, float]]  # estimates by title of the stage and quantity
    source: str  # the spec
    task: Sequence[Block] = ()  # what is given: pictures and data
    sought: Sequence[str] = ()  # what is to be found


def whole(work: Work, chapters: Sequence[Chapter], depth: str) -> list[Written]:
    """The whole note."""
    told = [each._replace(blocks=(*each.blocks, *work.own.get(each.name, ()))) for each in chapters]
    parts = [
        *task(work.task, work.sought, work.own.get("task", ())),
        *_own(work, {"introduction": tr("Introduction")}),
        *told,
        conclusions(chapters, work.warnings, work.own.get("conclusions", ())),
        *_own(work, {"literature": tr("References")}),
        appendix(work.errors, work.source, work.own.get("appendix", ())),
    ]
    written = Assembler(depth).written(parts)
    entries = sum(isinstance(block, Title) and block.level <= CONTENTS for block in written)
    return [_cover(work), Contents(tr("Contents"), entries), *written]


def _own(work: Work, titles: Mapping[str, str]) -> Iterator[Chapter]:
    """The parts that the person wrote."""
    for name, title in titles.items():
        if name in work.own:
            yield Chapter(name, title, work.own[name], number="")


def _cover(work: Work) -> Cover:
    who = work.who
    people = {tr("Done by"): who.done_by, tr("Group"): who.group, tr("Checked by"): who.checked_by}
    return Cover(
        tuple(who.organisation),
        (
            tr("Explanatory note"),
            who.work or tr("to the course project"),
            who.course or tr("on the theory of mechanisms and machines"),
        ),
        work.title,
        tuple((what, name) for what, name in people.items() if name),
        " ".join(each for each in (who.place, who.year) if each),
        who.designation,
    )
