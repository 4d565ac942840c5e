"""What ``class mark`` and ``class hints`` print."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.classroom.marking import Marked, Marks
from tmmcalc.classroom.marksheets import grades, hints_of, listed
from tmmcalc.classroom.model import Keybook
from tmmcalc.classroom.statistics import Statistics
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.classroom.wording import header_of, standing_said
from tmmcalc.core.notes import Phrase
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.language import spoken, tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

SHOWN = 5  # mistakes that are told


def marks_document(marks: Marks, statistics: Statistics) -> Document:
    """The marks of a class and what they have in common; no number of the key."""
    mean = None if math.isnan(statistics.mean) else statistics.mean
    facts = (
        Fact("handed in", str(statistics.students), {"students": statistics.students}),
        Fact("nothing from", str(len(marks.absent)), {"absent": len(marks.absent)}),
        Fact("not read", str(len(marks.refused)), {"refused": len(marks.refused)}),
        Fact("empty tables", str(len(marks.empty)), {"empty": len(marks.empty)}),
        Fact("mean", "" if mean is None else f"{number(mean, 4)} of {number(marks.most)} points", {"mean": mean}),
    )
    sheet = grades(marks)
    items = Document("asked results", table=_items(marks, statistics))
    given = View(sheet.headers[:4], [["" if cell is None else cell for cell in column] for column in sheet.columns[:4]])
    return Document("marks", facts, tuple(_notes(marks, statistics)), given, parts=(items,))


def _items(marks: Marks, statistics: Statistics) -> View:
    names = [marks.items[went.item].name for went in statistics.items]
    shares = ["" if math.isnan(went.share) else round(100 * went.share, 1) for went in statistics.items]
    right = [went.counts.get(Standing.right, 0) for went in statistics.items]
    wrong = [went.counts.get(Standing.wrong, 0) for went in statistics.items]
    return View(["item", "points[%]", "right", "wrong"], [names, shares, right, wrong])


def _notes(marks: Marks, statistics: Statistics) -> Iterator[Phrase]:
    for made in statistics.made[:SHOWN]:
        titles = " / ".join(dict.fromkeys(tr_name(marks.mistakes[m].title) for m in made.mistakes))
        yield Phrase("note: {mistake}: variants {variants}", mistake=titles, variants=listed(made.numbers))
    for equal in statistics.equal[:SHOWN]:
        yield Phrase(
            "note: {item}: {answer} stands in variants {variants}, where other numbers are right",
            item=marks.items[equal.item].name,
            answer=equal.text,
            variants=listed(equal.numbers),
        )
    for foreign in statistics.foreign[:SHOWN]:
        yield Phrase(
            "note: variant {number}: of its wrong answers {count} are right in variant {other}",
            number=foreign.number,
            count=len(foreign.items),
            other=foreign.other,
        )


def hints_document(marked: Marked, book: Keybook) -> Document:
    """How the answers of a student stand, and hints; no number but his own."""
    plain = spoken() == "en"
    rows = [
        (item.name, tr_unit(item.unit), answer.text, str(standing) if plain else standing_said(standing))
        for item, answer, standing in zip(book.items, marked.answers, marked.standings, strict=True)
    ]
    headers = ["asked", "unit", "answer", "it is"]
    if not plain:
        headers = [header_of(each, "hints") for each in ("item", "unit", "answer", "is")]
    notes = tuple(tr("hint: {line}", line=line) for line in hints_of(book.items, book.mistakes, marked))
    return Document(tr("hints"), notes=notes, table=View(headers, [*map(list, zip(*rows, strict=True))]))
