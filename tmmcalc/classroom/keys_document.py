"""What ``tmmcalc class keys`` prints: what is right of each variant, and what comes out with each mistake."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tmmcalc.classroom.keybook import HEADERS, rows_of, significant
from tmmcalc.classroom.keying import clashes, classes_of
from tmmcalc.classroom.model import Item, Keybook
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
            _right_too(book),
        ),
        parts=(right, Document("mistakes", table=_mistakes(book), wide=True)),
    )


def _mistakes(book: Keybook) -> View:
    """A row for every variant and mistake: what comes out in each item, and where that is right within tolerance.

    Beside it stands the first mistake that looks alike.
    """
    several = len(book.keys) > 1
    headers = [*("variant",) * several, "mistake", *map(_header, book.items), "right too", "alike", "what"]
    rows: list[list[Any]] = []
    for key in book.keys:
        hidden = clashes(key, book.items)
        alike = {at: each[0] for each in classes_of(key, book.items, book.mistakes) for at in each}
        for at, (told, values) in enumerate(zip(book.mistakes, key.mistaken, strict=True)):
            if at in alike:
                like = "" if alike[at] == at else book.mistakes[alike[at]].name
                right = ", ".join(book.items[k].name for one, k in hidden if one == at)
                cells = [_cell(value, item) for value, item in zip(values, book.items, strict=True)]
                rows.append([*(key.number,) * several, told.name, *cells, right, like, tr_name(told.title)])
    return View(headers, [*map(list, zip(*rows, strict=True))] or [[] for _ in headers])


def _right_too(book: Keybook) -> Fact:
    """In how many answers a mistake cannot be seen, as the right one comes out."""
    pairs = {(key.number, k) for key in book.keys for _, k in clashes(key, book.items)}
    names = [item.name for k, item in enumerate(book.items) if any(k == each for _, each in pairs)]
    many = f"{len(pairs)} answers, of {', '.join(names)}" if pairs else "no answer"
    return Fact("right with a mistake", many, {"right_too": len(pairs)})


def of_variants(book: Keybook, numbers: Sequence[int]) -> Keybook:
    """The book with these variants alone."""
    keep = [at for at, key in enumerate(book.keys) if key.number in numbers]
    made_of = tuple(book.made_of[at] for at in keep) if book.made_of else ()
    return Keybook(book.items, book.mistakes, tuple(book.keys[at] for at in keep), made_of)


def _header(item: Item) -> str:
    return f"{item.name}[{item.unit}]" if item.unit else item.name


def _cell(value: float, item: Item) -> str:
    return "" if math.isnan(value) else significant(value, item.digits)
