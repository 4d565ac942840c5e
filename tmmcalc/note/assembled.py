"""The note as it is written in every format: sections and formulas numbered, names explained once, lines worked out."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from tmmcalc.report.drawing.box import Box as Rectangle
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula import setting
from tmmcalc.report.formula.digits import Worked, result_of, worked
from tmmcalc.report.formula.layout import Box, Gap, Row, Word
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.setting import Shown, printed, quantity
from tmmcalc.report.formula.tree import Name, Node, Statement, mapped, names
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Chapter, Display, Figure, Heading, Line, Listing, Paragraph, Table

REFERENCE = re.compile(r"\{((?:tab|eq|fig):\w+)\}")
COUNTER = re.compile(r"(?<=_)(\w*)i(?=\^|$)|(?<=,)i(?=\})")


class Title(NamedTuple):
    """A heading with its number: ``2.3`` of level 2."""

    number: str
    text: str
    level: int


class Text(NamedTuple):
    """A paragraph: texts and formulas in turn."""

    parts: tuple[str | Box, ...]


class Equation(NamedTuple):
    """A formula on lines of its own: parts that equality joins; a number, or none."""

    parts: tuple[Row, ...]
    number: str = ""
    lead: str = ""  # words before it: ``in position 3``


class Grid(NamedTuple):
    """A table; its number stands in the caption."""

    caption: str
    head: tuple[Text, ...]
    rows: tuple[tuple[Text, ...], ...]


class Image(NamedTuple):
    """A picture; its number stands in the caption."""

    caption: str
    drawing: Drawing


class Points(NamedTuple):
    """A list."""

    items: tuple[Text, ...]


Written = Title | Text | Equation | Grid | Image | Points


class Checked(NamedTuple):
    """One line of the note with what it was worked out to, for the checks."""

    formula: Statement
    place: str
    found: Worked


class Assembler:
    """Numbers and explains what comes, in its order."""

    def __init__(self) -> None:
        self.lines: list[Checked] = []
        self.numbers: dict[str, str] = {}  # of tables, figures and formulas, by their keys
        self._sections = [0, 0, 0]
        self._equations = self._tables = self._figures = 0
        self._explained: dict[str, tuple[str, str]] = {}  # meaning and unit of a name

    def written(self, chapters: Iterable[Chapter]) -> list[Written]:
        """What is written of these chapters, references in their texts replaced by numbers."""
        found: list[Written] = []
        for chapter in chapters:
            found += [self._title(chapter.title, 1), *self._written(chapter.blocks)]
        return [_referred(each, self.numbers) for each in found]

    def _written(self, blocks: Iterable[Block]) -> Iterator[Written]:
        for block in blocks:
            match block:
                case Heading(text, level):
                    yield self._title(text, level)
                case Paragraph(text):
                    yield inline(text)
                case Display(formula, key):
                    yield Equation((setting.statement(formula),), self._numbered(key))
                case Line():
                    yield from self._line(block)
                case Listing(items):
                    yield Points(tuple(inline(item) for item in items))
                case Table(caption, head, rows, key):
                    self._tables += 1
                    number = f"{self._sections[0]}.{self._tables}"
                    self.numbers[f"tab:{key}"] = number
                    cells = tuple(tuple(map(inline, row)) for row in rows)
                    said = tr("Table {number} – {caption}", number=number, caption=caption)
                    yield Grid(said, tuple(map(inline, head)), cells)
                case Figure(caption, _, _, key):
                    self._figures += 1
                    number = f"{self._sections[0]}.{self._figures}"
                    self.numbers[f"fig:{key}"] = number
                    yield Image(tr("Figure {number} – {caption}", number=number, caption=caption), drawn(block))

    def _title(self, text: str, level: int) -> Title:
        self._sections[level - 1] += 1
        self._sections[level:] = [0] * (3 - level)
        if level == 1:
            self._equations = self._tables = self._figures = 0
        return Title(".".join(map(str, self._sections[:level])), text, level)

    def _numbered(self, key: str) -> str:
        self._equations += 1
        number = self.numbers[f"eq:{key}"] = f"{self._sections[0]}.{self._equations}"
        return number

    def _line(self, line: Line) -> Iterator[Written]:
        left, right = line.formula.sides
        yield Equation((setting.side(left), setting.side(right)), self._numbered(line.key))
        yield from self._where(line)
        for place in line.places:
            given = result_of(left, place.lexicon)
            assert isinstance(given.value, float)
            found = worked(right, place.lexicon, given.value, unit=given.unit, digits=line.digits)
            self.lines.append(Checked(line.formula, place.name, found))
            numbers = setting.side(found.tree, found.shown)
            own = _indexed(left, place.index) if place.index else left
            parts = (setting.side(own), numbers, with_unit(found.result, given.unit))
            same = not found.shown or plain(numbers) == plain(parts[2].boxes[0])
            yield Equation((parts[0], parts[2]) if same else parts, lead=place.name)

    def _where(self, line: Line) -> Iterator[Written]:
        """The names that stand for the first time, or for something else than before, with meaning and unit."""
        groups: dict[tuple[str, str], list[str]] = {}
        for key in names(line.formula):
            _, unit, meaning = line.places[0].lexicon[key]
            if meaning and self._explained.get(key) != (meaning, unit):
                self._explained[key] = meaning, unit
                groups.setdefault((meaning, unit), []).append(key)
        parts: list[str | Box] = []
        for k, ((meaning, unit), keys) in enumerate(groups.items()):
            parts.append("; " if k else tr("where") + " ")
            for j, key in enumerate(keys):
                parts += [", "] * bool(j) + [quantity(key)]
            parts.append(f" – {meaning}" + (f", {shown_unit(unit)}" if unit else ""))
        if parts:
            yield Text((*parts, "."))


def _indexed(node: Node, index: str) -> Node:
    """The node with this index in place of the i at the end of indices."""
    if isinstance(node, Name):
        return Name(COUNTER.sub(lambda found: (found[1] or "") + index, node.key))
    return mapped(node, lambda part: _indexed(part, index))


def _referred(block: Written, numbers: Mapping[str, str]) -> Written:
    """The block with references in its texts as numbers."""
    if isinstance(block, Points):
        return Points(tuple(_referring(item, numbers) for item in block.items))
    return _referring(block, numbers) if isinstance(block, Text) else block


def _referring(text: Text, numbers: Mapping[str, str]) -> Text:
    def number(found: re.Match[str]) -> str:
        return numbers[found[1]]

    return Text(tuple(REFERENCE.sub(number, part) if isinstance(part, str) else part for part in text.parts))


def drawn(figure: Figure) -> Drawing:
    """The picture at its size."""
    drawing = Drawing(*figure.size, figure.caption)
    figure.draw(drawing, Rectangle(0.0, 0.0, *figure.size))
    return drawing


def shown_unit(unit: str) -> str:
    """A unit as it stands after a number; of an angle the sign of degrees."""
    return "°" if unit == "deg" else tr_unit(unit)


def with_unit(digits: str, unit: str) -> Row:
    """A result with its unit."""
    number = printed(Shown(digits, unit == "deg"))
    return Row((number,)) if unit in ("", "deg") else Row((number, Gap(), Word(tr_unit(unit))))


def inline(text: str) -> Text:
    """A text with its formulas between ``$``."""
    from tmmcalc.report.formula.syntax import read

    parts = [setting.statement(read(part)) if k % 2 else part for k, part in enumerate(text.split("$"))]
    return Text(tuple(part for part in parts if part != ""))
