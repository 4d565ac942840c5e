"""The page of the keys for the teacher: what is asked and how it is judged, and what is right of every variant."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tmmcalc.classroom.keybook import significant
from tmmcalc.classroom.papers.tasksheet import said_in, tolerance_of, unit_of
from tmmcalc.note.assembled import Assembler
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Chapter, Paragraph, Table
from tmmcalc.report.numbers import percent

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Item, Key, Keybook
    from tmmcalc.note.tree import Written

JOINER = "\u2060"  # before a name: the head of a column begins with a capital where it begins with a word
ACROSS = 12  # columns of values beside those of the variant


def overview(book: Keybook, title: str) -> list[Written]:
    """The page, in the language in force."""
    said = tr("Keys: {title}", title=said_in(title)) if title else tr("Keys")
    return Assembler().written([Chapter("keys", said, tuple(_blocks(book)), number="")])


def _blocks(book: Keybook) -> Iterator[Block]:
    yield Paragraph(tr("For the teacher alone. Table {tab:judged} says how answers are judged."))
    head = (
        *(tr("Name"), tr("Also called"), tr("Result"), tr("Unit"), tr("Digits"), tr("Tolerance")),
        *(tr("By plans"), tr("Points for it"), tr("Also right")),
    )
    yield Table(tr("Asked results"), head, tuple(map(_judged, book.items)), "judged")
    yield Paragraph(tr("Table {tab:keys0} has the right values of all variants, to the digits that are asked for."))
    named = any(key.student for key in book.keys)
    for at in range(0, len(book.items), ACROSS):
        items = book.items[at : at + ACROSS]
        columns = (tr("Variant"), *([tr("Student")] if named else []), *map(_headed, items))
        rows = tuple(_row(key, items, at, named=named) for key in book.keys)
        yield Table(tr("Right values"), columns, rows, f"keys{at}")


def _judged(item: Item) -> tuple[str, ...]:
    also = tr("the other sign") if item.either_sense else "–"
    return (
        *(said_in(item.name), said_in(", ".join(item.also)) or "–", said_in(item.result), unit_of(item) or "–"),
        *(str(item.digits), tolerance_of(item), percent(item.plans), tr_number(f"{item.weight:g}"), also),
    )


def _headed(item: Item) -> str:
    name = f"{JOINER}{said_in(item.name)}"
    return f"{name}, {unit_of(item)}" if unit_of(item) else name


def _row(key: Key, items: Sequence[Item], at: int, *, named: bool) -> tuple[str, ...]:
    values = key.values[at : at + len(items)]
    told = (printed(value, item) for value, item in zip(values, items, strict=True))
    return (f"{key.number:02d}", *([said_in(key.student) or "–"] if named else []), *told)


def printed(value: float, item: Item) -> str:
    """A right value to the digits that are asked for, in the language in force."""
    return tr_number(significant(value, item.digits)).replace("-", "−")
