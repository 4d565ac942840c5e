"""What ``tmmcalc class keys`` prints: what is right of each variant, and what comes out with each mistake."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tmmcalc.classroom.keybook import HEADERS, rows_of, significant
from tmmcalc.classroom.keying import clashes, classes_of
from tmmcalc.classroom.model import Item, Keybook
from tmmcalc.core.notes import Phrase
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.language import tr_name


def keys_document(book: Keybook, title: str) -> Document:
    """The document of some variants: asked results with what counts as right, then the mistakes."""
    rows = [*rows_of(book)]
    right = Document(
        "asked results",
        table=View(HEADERS, [*map(list, zip(*rows, strict=True))] or [[] for _ in HEADERS]),
        wide=True,
    )
    return Document(
        title,
        (
            Fact("variants", str(len(book.keys)), {"variants": len(book.keys)}),
            Fact("asked results", str(len(book.items)), {"items": len(book.items)}),
            Fact("known mistakes", str(len(book.mistakes)), {"mistakes": len(book.mistakes)}),
        ),
        tuple(_notes(book)),
        parts=(right, Document("mistakes", table=_mistakes(book), wide=True)),
    )


def _mistakes(book: Keybook) -> View:
    """A row for every variant and mistake: what comes out in each item, with the first mistake that looks alike."""
    several = len(book.keys) > 1
    headers = [*("variant",) * several, "mistake", *map(_header, book.items), "alike", "what"]
    rows: list[list[Any]] = []
    for key in book.keys:
        alike = {at: each[0] for each in classes_of(key, book.items, book.mistakes) for at in each}
        for at, (told, values) in enumerate(zip(book.mistakes, key.mistaken, strict=True)):
            if at in alike:
                like = "" if alike[at] == at else book.mistakes[alike[at]].name
                cells = [_cell(value, item) for value, item in zip(values, book.items, strict=True)]
                rows.append([*(key.number,) * several, told.name, *cells, like, tr_name(told.title)])
    return View(headers, [*map(list, zip(*rows, strict=True))] or [[] for _ in headers])


def _notes(book: Keybook) -> list[Phrase]:
    """Items in which a mistake gives the right answer, by how many variants it does."""
    found: dict[tuple[int, int], list[int]] = {}
    for key in book.keys:
        for pair in clashes(key, book.items):
            found.setdefault(pair, []).append(key.number)
    return [
        Phrase(
            "note: {item} is right within tolerance though {mistake}: variants {variants}",
            item=book.items[k].name,
            mistake=book.mistakes[at].title,
            variants=tuple(map(str, numbers)),
        )
        for (at, k), numbers in found.items()
    ]


def of_variants(book: Keybook, numbers: Sequence[int]) -> Keybook:
    """The book with these variants alone."""
    keep = [at for at, key in enumerate(book.keys) if key.number in numbers]
    made_of = tuple(book.made_of[at] for at in keep) if book.made_of else ()
    return Keybook(book.items, book.mistakes, tuple(book.keys[at] for at in keep), made_of)


def _header(item: Item) -> str:
    return f"{item.name}[{item.unit}]" if item.unit else item.name


def _cell(value: float, item: Item) -> str:
    return "" if math.isnan(value) else significant(value, item.digits)
