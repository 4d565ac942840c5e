"""The task sheet of a student: the scheme, his own data, those that all have, what is asked; no number of the key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.classroom.model import Item
from tmmcalc.classroom.neighbours import MACHINES, NAMED
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import Place, parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.note.task import row_of
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Chapter, Datum, Figure, Listing, Paragraph, Table
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

BLANK = "\u00a0" * 36  # room for an answer
Mark = tuple[str, tuple[str, ...]]  # what a datum is, and how it is called
Own = frozenset[Mark]


@record
class Given:
    """What a variant is given."""

    scheme: tuple[Figure, ...]
    said: tuple[Paragraph, ...]  # of the scene, in words
    own: tuple[Datum, ...]  # that variants differ in
    common: tuple[Datum, ...]


def given_of(blocks: Sequence[Block], own: Own, further: Mapping[str, str]) -> Given:
    """What a run is given, parted by what is drawn; ``further`` are drawn keys that it does not tell, with values."""
    data = [block for block in blocks if isinstance(block, Datum)]
    return Given(
        tuple(block for block in blocks if isinstance(block, Figure)),
        tuple(block for block in blocks if isinstance(block, Paragraph)),
        (*(each for each in data if mark_of(each) in own), *(Datum(key, text=value) for key, value in further.items())),
        tuple(each for each in data if mark_of(each) not in own),
    )


def mark_of(datum: Datum) -> Mark:
    """By what a datum is known in another variant."""
    return datum.what, datum.keys


def meanings_of(items: Sequence[Item], run: RunResult) -> tuple[str, ...]:
    """What each asked result is, in words of the language in force."""
    scene = Scene(run.spec, run.results)
    found = []
    for item in items:
        name = parse(item.result)
        said = said_in(item.meaning) or tr_name(one(name, run.results, scene).meaning)
        if name.place is not None and not name.of and not item.meaning:
            said = f"{said}, {_placed(name.stage, name.place)}"
        found.append(said)
    return tuple(found)


def _placed(stage: str, place: Place) -> str:
    if stage in NAMED:
        return tr("link {link}", link=place.first)
    if not place.column:
        return tr("in position {label}", label=place.first).replace(f" {place.first}", f"\u00a0{place.first}")
    value = tr_number(place.first).replace(" deg", "°").replace("*", "·")
    return tr("at {what} = {value}", what=f"${place.column}$", value=value)


def task_sheet(
    title: str, who: str, given: Given, items: Sequence[Item], meanings: Sequence[str], *, drawn: bool = True
) -> list[Chapter]:
    """The sheet, in the language in force; what is not ``drawn``, as plain text, has no scheme and speaks of none."""
    said = tr("Task: {title}", title=said_in(title)) if title else tr("Task")
    shown = given if drawn else replace(given, scheme=())
    return [Chapter("sheet", said, tuple(_blocks(who, shown, items, meanings)), number="")]


def _blocks(who: str, given: Given, items: Sequence[Item], meanings: Sequence[str]) -> Iterator[Block]:
    yield Paragraph(said_in(who))
    if given.scheme:
        figure = f"{{fig:{given.scheme[0].key}}}"
        yield Paragraph(tr("The scheme is shown in figure {figure}.", figure=figure))
        yield from given.scheme
    yield from given.said
    head = (tr("Quantity"), tr("Designation"), tr("Value"))
    if given.own:
        yield Paragraph(tr("The data of this variant alone (table {tab:own}):"))
        yield Table(tr("Data of this variant alone"), head, tuple(map(row_of, given.own)), "own")
    if given.common:
        yield Paragraph(tr("The data that are the same in all variants (table {tab:common}):"))
        yield Table(tr("Data of all variants"), head, tuple(map(row_of, given.common)), "common")
    yield Listing(tuple(_rules(items)))
    yield Paragraph(tr("What is to be found (table {tab:asked}):"))
    columns = (tr("Name"), tr("What it is"), tr("Unit"), tr("Digits"), tr("Tolerance"), tr("Answer"))
    rows = tuple(_asked(item, meaning) for item, meaning in zip(items, meanings, strict=True))
    yield Table(tr("Asked results"), columns, rows, "asked")


def _asked(item: Item, meaning: str) -> tuple[str, ...]:
    sign = tr("; its sign is left open") if item.either_sense else ""
    return said_in(item.name), meaning + sign, unit_of(item) or "–", str(item.digits), tolerance_of(item), BLANK


def tolerance_of(item: Item) -> str:
    """By how much an answer may be off: relative, or absolute where that is more."""
    part = f"{tr_number(number(100 * item.tolerance, 3))} %"
    if not item.within:
        return part
    return tr("{part} or {within}", part=part, within=f"{tr_number(number(item.within, 3))} {unit_of(item)}".strip())


def unit_of(item: Item) -> str:
    """In the language in force; of a number none, which the header of a column has as -."""
    return "" if item.unit == "-" else tr_unit(item.unit)


def senses_of(items: Sequence[Item]) -> Iterator[str]:
    """How positions are counted, and in which sense what is asked for is positive."""
    names = [parse(item.result) for item in items]
    of_machine = [name for name in names if STAGES[name.stage].room in MACHINES]
    if any(name.place is not None and not name.place.column for name in of_machine):
        yield tr("Positions are counted from 0 on, by equal steps in the sense of the motion.")
    if of_machine:
        yield tr("Angles, angular quantities and moments are positive counter-clockwise.")
    if any(name.stage in NAMED for name in names):
        yield tr("Speeds and torques of links are positive in the sense of a positive given speed.")


def _rules(items: Sequence[Item]) -> Iterator[str]:
    yield from senses_of(items)
    yield tr("“Digits” are the significant ones that an answer has; it is right within its tolerance.")
    yield tr("Answers are handed in as a table under the names of the first column, with their units.")


def said_in(text: str) -> str:
    """A text that somebody has written, where it marks up nothing."""
    return text.translate({ord("$"): None, ord("{"): "(", ord("}"): ")"})
