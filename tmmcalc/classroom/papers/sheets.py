"""Task sheets of a class with empty tables for its answers, and its worked solutions."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.classroom.papers.making import make_papers, order_of, traced
from tmmcalc.core.atomic import blamed_on, replace_file
from tmmcalc.note.forms import FORMS
from tmmcalc.report.language import tr, tr_unit

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Item
    from tmmcalc.classroom.state import Class

SHEETS, ANSWERS = "sheets", "answers"
MAKER = "tmmcalc.classroom.papers.making:sheet_bytes"
NOTES = "tmmcalc.classroom.papers.making:note_bytes"
PAPER = re.compile(rf"\d{{2,}}(-.*)?\.({'|'.join(FORMS)})")


def write_sheets(
    folder: Path,
    made: Class,
    items: Sequence[Item],
    form: str,
    *,
    jobs: int | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Callable[[int], None] = lambda done: None,
) -> tuple[Path, Path]:
    """A task sheet for each variant, and an empty table of answers where there is none yet; their folders.

    They are in the language in force. Sheets of variants that the class has no more are removed. Raises NoSolutionError
    for a variant that has none.
    """
    assignment = made.file(folder)
    own, further = traced(assignment)
    sheets, answers = folder / SHEETS, folder / ANSWERS
    orders = [order_of(each, items, sheets / f"{each.stem}.{form}", MAKER, own, further) for each in made.variants]
    make_papers(assignment, orders, jobs=jobs, tell=tell, told=told)
    stems = {each.stem for each in made.variants}
    for file in sheets.iterdir():
        if PAPER.fullmatch(file.name) and file.stem not in stems:
            file.unlink()
    with blamed_on(answers, "made"):
        answers.mkdir(exist_ok=True)
    table = _blank(items)
    for stem in stems:
        file = answers / f"{stem}.csv"
        if not file.exists():  # what a student has handed in stays
            replace_file(file, table)
    return sheets, answers


def write_notes(
    folder: Path,
    made: Class,
    place: Path,
    form: str,
    *,
    jobs: int | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Callable[[int], None] = lambda done: None,
) -> None:
    """The worked solution of each variant, for the teacher, in the language in force."""
    orders = [order_of(each, (), place / f"{each.stem}.{form}", NOTES) for each in made.variants]
    make_papers(made.file(folder), orders, jobs=jobs, tell=tell, told=told)


def _blank(items: Sequence[Item]) -> bytes:
    """Names and units with room for values: semicolons part them, since a comma may be decimal."""
    text = io.StringIO()
    table = csv.writer(text, delimiter=";", lineterminator="\n")
    table.writerow((tr("Quantity"), tr("Value"), tr("Unit")))
    table.writerows((item.name, "", tr_unit(item.unit)) for item in items)
    return text.getvalue().encode("utf-8-sig")
