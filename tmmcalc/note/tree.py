"""The note before it has a format: numbered, explained, in the order in which it is read. Writers know nothing else."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from tmmcalc.report.drawing.lettering import advance
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.breaking import width
from tmmcalc.report.formula.layout import Box, Row
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking, spoken, tr_unit
from tmmcalc.spec.dimensions import UNITS

POINT = 25.4 / 72.0  # of letters [mm]
ACROSS, ALONG = 175.0, 257.0  # width of the text of a page, of one that is turned [mm]
CELL = 2.4  # of a cell of a table beside its letters, with its line [mm]
NUMERIC = re.compile(r"[-−+–\d.,  \u202f%°]*")  # what a cell of numbers has


class Cover(NamedTuple):
    """The title page: lines from top to bottom in groups that stand apart."""

    head: tuple[str, ...]  # who gives it out
    kind: tuple[str, ...]  # what it is
    title: str
    people: tuple[tuple[str, str], ...]  # what each did, and the name
    foot: str  # place and year
    designation: str


class Contents(NamedTuple):
    """The list of titles with their pages."""

    title: str
    entries: int = 0  # about how many there are


class Title(NamedTuple):
    """A heading with its number: ``2.3`` of level 2; introduction and conclusions have none."""

    number: str
    text: Text
    level: int

    def __str__(self) -> str:
        return f"{self.number} {plain_text(self.text)}".strip()


class Reference(NamedTuple):
    """The number of a table, a figure or a formula within a text."""

    key: str  # ``tab:links``
    number: str


class Text(NamedTuple):
    """A paragraph: words, formulas and references in turn."""

    parts: tuple[str | Box | Reference, ...]
    explains: bool = False  # what the letters of the formula before it are


class Equation(NamedTuple):
    """A formula on lines of its own: parts that equality joins; a number, or none."""

    parts: tuple[Row, ...]
    number: str = ""
    lead: str = ""  # words before it: ``in position 3``
    key: str = ""


class Caption(NamedTuple):
    """What stands over a table or under a figure: ``Table``, ``2.1``, ``Links``."""

    word: str
    number: str
    text: Text
    key: str = ""

    def __str__(self) -> str:
        return plain_text(self.whole)

    @property
    def whole(self) -> Text:
        """All of its line."""
        return Text((f"{self.word} {self.number} – ", *self.text.parts))


class Grid(NamedTuple):
    """A table."""

    caption: Caption
    head: tuple[Text, ...]
    rows: tuple[tuple[Text, ...], ...]


class Image(NamedTuple):
    """A picture."""

    caption: Caption
    drawing: Drawing


class Points(NamedTuple):
    """A list."""

    items: tuple[Text, ...]


class Source(NamedTuple):
    """Lines as they are, as those of a file."""

    text: str


Written = Cover | Contents | Title | Text | Equation | Grid | Image | Points | Source


def plain_text(text: Text) -> str:
    """A paragraph as it is read in a terminal."""
    return "".join(
        part if isinstance(part, str) else part.number if isinstance(part, Reference) else plain(part)
        for part in text.parts
    )


def leads(text: Text) -> bool:
    """Whether a paragraph ends with a colon: what it leads to stands with it."""
    last = text.parts[-1] if text.parts else ""
    return isinstance(last, str) and last.rstrip().endswith(":")


def tied(text: str) -> str:
    """A text whose lines begin neither with a dash, nor with an equals sign, nor with the unit of a number.

    >>> tied("l – length; 0.02 (m/s)/mm, 3 positions").replace("\u00a0", "~")
    'l~– length; 0.02~(m/s)/mm, 3 positions'
    """
    return _loose(spoken()).sub("\u00a0", text)


@cache
def unit_names(language: str) -> frozenset[str]:
    """What units are called, as in the spec and in a language."""
    names = {name for units in UNITS.values() for unit in units for name in re.findall("[A-Za-z]+", unit)}
    with speaking(language):
        return frozenset(names | set(map(tr_unit, names)))


@cache
def _loose(language: str) -> re.Pattern[str]:
    """A space at which no line ends; a text that begins with a unit goes on from a formula."""
    either = "|".join(sorted(unit_names(language), key=len, reverse=True))
    return re.compile(rf" (?=[–—] )|(?<==) | (?== )|(?:(?<=\d)|^) (?=%|\(?(?:{either})(?!\w))")


def part_width(part: str | Box | Reference) -> float:
    """How wide a part of a text is [em]; of a formula rather more than less."""
    match part:
        case str():
            return advance(part)
        case Reference(_, number):
            return advance(number)
    return width(part)


def numeric(cells: Sequence[Text]) -> bool:
    """Whether a column is of numbers."""
    return all(NUMERIC.fullmatch(plain_text(cell)) for cell in cells)
