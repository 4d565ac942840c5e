"""What ``tmmcalc class keys`` prints: what is right of each variant, and what comes out with each mistake."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.classroom.keybook import right_of, significant
from tmmcalc.classroom.keying import clashes, classes_of
from tmmcalc.classroom.model import Item, Keybook
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.language import tr_name


def keys_document(book: Keybook, title: str, of: int = 0) -> Document:
    """The document of some variants: asked results with what counts as right, which they are, then the mistakes.

    ``of`` are all that there are, if they are more.
    """
    names = View(("name", "result"), [[each.name for each in book.items], [each.result for each in book.items]])
    mistakes = Document("mistakes", table=_mistakes(book), wide=True, more="keys.toml and --format json have all")
    return Document(
        title,
        (
            Fact("variants", _variants(book, of), {"variants": len(book.keys)}),
            Fact("asked results", str(len(book.items)), {"items": len(book.items)}),
            Fact("known mistakes", str(len(book.mistakes)), {"mistakes": len(book.mistakes)}),
            _right_too(book),
        ),
        tuple(_hidden(book)),
        parts=(Document("right", table=_right(book)), Document("asked results", table=names), mistakes),
    )


def _variants(book: Keybook, of: int) -> str:
    """How many are shown, and of how many; of one its number and its student."""
    shown = str(len(book.keys)) if of <= len(book.keys) else f"{len(book.keys)} of {of}"
    if len(book.keys) != 1:
        return shown
    return f"{shown}: number {book.keys[0].number}{f', {book.keys[0].student}' if book.keys[0].student else ''}"


def _right(book: Keybook) -> View:
    """A row for every variant and asked result; no column is cut, so that none is lost."""
    headers = ("variant", "name", "value", "unit", "tolerance", "also right")
    rows = [
        (key.number, item.name, value, item.unit, allowed, also)
        for key in book.keys
        for item, own in zip(book.items, key.values, strict=True)
        for value, allowed, also in (right_of(own, item),)
    ]
    columns = dict(zip(headers, map(list, zip(*rows, strict=True)), strict=True)) if rows else {}
    left_out = {"variant"} if len(book.keys) == 1 else set[str]()
    left_out |= {"also right"} - {header for header, cells in columns.items() if any(cells)}
    kept = [header for header in headers if header not in left_out]
    return View(kept, [columns.get(header, []) for header in kept])


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
    count = len({(key.number, k) for key in book.keys for _, k in clashes(key, book.items)})
    text = f"{count} {'answer' if count == 1 else 'answers'}" if count else "no answer"
    return Fact("right with a mistake", text, {"right_too": count})


def _hidden(book: Keybook) -> Iterator[str]:
    """A note for each asked result that is right with some mistake: with which, in how many variants, what to do."""
    found: dict[int, dict[str, set[int]]] = {}
    for key in book.keys:
        for at, k in clashes(key, book.items):
            found.setdefault(k, {}).setdefault(book.mistakes[at].name, set()).add(key.number)
    for k, mistakes in sorted(found.items()):
        count = len(set[int]().union(*mistakes.values()))
        where = f" in {count} of {len(book.keys)} variants" if len(book.keys) > 1 else ""
        rule = f"{book.items[k].name} is right{where} with a mistake too ({', '.join(mistakes)})"
        yield f"note: {rule}: make its tolerance smaller, or ask another result"


def of_variants(book: Keybook, numbers: Sequence[int]) -> Keybook:
    """The book with these variants alone."""
    keep = [at for at, key in enumerate(book.keys) if key.number in numbers]
    made_of = tuple(book.made_of[at] for at in keep) if book.made_of else ()
    return Keybook(book.items, book.mistakes, tuple(book.keys[at] for at in keep), made_of)


def _header(item: Item) -> str:
    return f"{item.name}[{item.unit}]" if item.unit else item.name


def _cell(value: float, item: Item) -> str:
    return "" if math.isnan(value) else significant(value, item.digits)
