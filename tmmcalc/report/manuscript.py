"""What a note is made of before it has a format: headings, paragraphs, formulas with numbers, lists, tables.

Texts are in the language in force. Within ``$`` stands a formula as `tmmcalc.report.formula.syntax` reads it.
``{eq:KEY}``, ``{tab:KEY}``, ``{fig:KEY}`` are replaced by the number of what has this key.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.report.formula.digits import RESULT, Given

if TYPE_CHECKING:
    from tmmcalc.report.drawing.box import Box
    from tmmcalc.report.drawing.shapes import Drawing
    from tmmcalc.report.formula.tree import Statement

Lexicon = dict[str, Given]  # the quantities of a scene at one place, by their names in formulas


class Heading(NamedTuple):
    """The title of a part of a chapter (level 2), or of a part of it (3); chapters have theirs from the manifest.

    As in captions, formulas stand in it between ``$``.
    """

    text: str
    level: int = 2


class Paragraph(NamedTuple):
    """Sentences."""

    text: str


class Display(NamedTuple):
    """A formula in letters alone: a vector equation, a law."""

    formula: Statement
    key: str = ""


class Place(NamedTuple):
    """A place at which a formula is worked out: what is said of it, ``in position 3``, and its quantities.

    With an ``index`` the left side of a formula of ``r_ai`` has it in place of i: ``r_a2``.
    """

    name: str
    lexicon: Lexicon
    index: str = ""  # type: ignore[assignment]


class Line(NamedTuple):
    """A formula in letters, then with the numbers of each place: its left side is a name whose value is the program's.

    It may be a function of names too: ``inv(alpha)``, a number. Names that stand for the first time, or for something
    else than before, are explained by their meaning.
    """

    formula: Statement
    places: tuple[Place, ...]
    key: str = ""
    digits: int = RESULT


class Listing(NamedTuple):
    """Points of a list."""

    items: tuple[str, ...]


class Table(NamedTuple):
    """Cells as they are printed, with formulas between ``$``, under a head that is repeated on every page."""

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    key: str = ""


class Figure(NamedTuple):
    """A picture, drawn at the size at which it stands: ``draw(drawing, box)`` fills the whole rectangle."""

    caption: str
    draw: Callable[[Drawing, Box], object]
    size: tuple[float, float]  # width and height [mm]
    key: str = ""


class Result(NamedTuple):
    """A main result, which stands in the table of the conclusions: a quantity with what it is held against."""

    key: str  # its name in formulas
    given: Given
    limit: float | None = None  # in the unit of the quantity
    sense: str = ""  # ``<=`` or ``>=``: how it stands to the limit where that is kept
    place: str = ""  # what it is of, where several have one: ``wheel 1``


class Datum(NamedTuple):
    """What is given: its names in formulas with their values, or a text.

    It stands in the table of the task at the beginning of the note, or in that of its chapter, and on students' sheets.
    """

    what: str
    keys: tuple[str, ...] = ()
    values: tuple[float, ...] = ()
    unit: str = ""
    text: str = ""


class Verbatim(NamedTuple):
    """Lines as they are."""

    text: str


Block = Heading | Paragraph | Display | Line | Listing | Table | Figure | Result | Datum | Verbatim


class Chapter(NamedTuple):
    """What the stages of one subject tell."""

    name: str  # by which it is asked for
    title: str
    blocks: tuple[Block, ...]
    number: str | None = None  # that of the chapters that are counted; of others a letter, or nothing
