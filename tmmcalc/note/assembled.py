"""The note as it is written in every format: sections and formulas numbered, names explained once, lines worked out."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from tmmcalc.note.columns import asked, most
from tmmcalc.note.tree import (
    ACROSS,
    CELL,
    POINT,
    Caption,
    Equation,
    Grid,
    Image,
    Points,
    Reference,
    Source,
    Text,
    Title,
    Written,
    numeric,
    plain_text,
    unit_names,
)
from tmmcalc.report.drawing.box import Box as Rectangle
from tmmcalc.report.drawing.reach import trimmed
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula import setting
from tmmcalc.report.formula.digits import RESULT, Given, Worked, result_of, significant, worked
from tmmcalc.report.formula.layout import Box, Gap, Row, Word
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.setting import Shown, printed, quantity
from tmmcalc.report.formula.tree import Call, Name, Node, Over, Statement, Sum, mapped, names
from tmmcalc.report.formula.tree import parts as parts_of
from tmmcalc.report.language import possessive, several, spoken, tr, tr_unit
from tmmcalc.report.manuscript import (
    Block,
    Chapter,
    Datum,
    Display,
    Figure,
    Heading,
    Lexicon,
    Line,
    Listing,
    Paragraph,
    Place,
    Result,
    Table,
    Verbatim,
)
from tmmcalc.report.printing import ANSWERS, FULL, SHORT, printed_as
from tmmcalc.report.telling import folded

REFERENCE = re.compile(r"\{((?:tab|eq|fig):\w+)\}")
COUNTER = re.compile(r"(?<=_)(\w*)i(?=\^|$)|(?<=,)i(?=\})")
LENGTHS = ("m", "mm")

LONG = 20  # rows of a table that is folded where it is narrow
SMALL = 9.0 * POINT  # a letter M of a table [mm]
WORD = re.compile(r"[^\W\d_]{3,}")  # with which the head of a column begins
MANY, FIRST = 8, 3  # terms of a sum over an index: up to which all are shown, and those of a longer one before its last


class Checked(NamedTuple):
    """One line of the note with what it was worked out to, for the checks."""

    formula: Statement
    place: str
    found: Worked


class Assembler:
    """Numbers and explains what comes, in its order.

    ``depth`` is ``full``; ``short``, each formula at the first of its places alone; or ``answers``, no formulas, what
    they give in tables.
    """

    def __init__(self, depth: str = FULL) -> None:
        self.depth = depth
        self.lines: list[Checked] = []
        self._numbers: dict[str, str] = {}  # of tables, figures and formulas, by their keys
        self._chapters = 0
        self._prefix = ""  # of numbers in this chapter
        self._parts = [0, 0]  # how many of levels 2 and 3 there were
        self._counts: Counter[tuple[str, str]] = Counter()  # of tables, figures and formulas by chapter
        self._explained: dict[str, tuple[str, str]] = {}  # meaning and unit of a name
        self._turned = False  # whether the arctangent of a whole turn is explained
        self._told: dict[tuple[str, Statement], str] = {}  # numbers of the formulas of each chapter

    def written(self, chapters: Iterable[Chapter]) -> list[Written]:
        """What is written of these chapters, references in their texts replaced by numbers.

        Raises `KeyError` for a reference to nothing.
        """
        found: list[Written] = []
        for chapter in chapters:
            blocks = chapter.blocks if self.depth != ANSWERS else tuple(answers(chapter.blocks))
            if blocks:
                found += [self._chapter(chapter), *self._written(blocks)]
        return [_referred(each, self._numbers) for each in found]

    def _written(self, blocks: Sequence[Block]) -> Iterator[Written]:
        for block in _folded(blocks):
            match block:
                case Heading(text, level):
                    yield self._title(text, level)
                case Paragraph(text):
                    yield inline(text)._replace(explains=text.startswith(tr("where") + " "))
                case Display(formula, key):
                    yield Equation((setting.statement(formula),), self._numbered("eq", key), key=key)
                case Line():
                    yield from self._line(block)
                case Listing(items):
                    yield Points(tuple(inline(item) for item in items))
                case Result() | Datum():
                    continue
                case Verbatim(text):
                    yield Source(text)
                case Table(caption, head, rows, key):
                    said = Caption(tr("Table"), self._numbered("tab", key), inline(caption), key)
                    yield Grid(
                        said,
                        tuple(inline(_capital(each)) for each in head),
                        tuple(tuple(map(inline, row)) for row in rows),
                    )
                case Figure(caption, _, _, key):
                    yield Image(Caption(tr("Figure"), self._numbered("fig", key), inline(caption), key), drawn(block))

    def _chapter(self, chapter: Chapter) -> Title:
        """Its title; what stands in it is numbered by the chapter."""
        self._parts = [0, 0]
        if chapter.number is not None:
            self._prefix = chapter.number
            return Title("", inline(chapter.title), 1)
        self._chapters += 1
        self._prefix = str(self._chapters)
        return Title(self._prefix, inline(chapter.title), 1)

    def _title(self, text: str, level: int) -> Title:
        if not self._prefix:
            return Title("", inline(text), level)
        self._parts[level - 2] += 1
        self._parts[level - 1 :] = [0] * (3 - level)
        return Title(".".join([self._prefix, *map(str, self._parts[: level - 1])]), inline(text), level)

    def _numbered(self, kind: str, key: str) -> str:
        self._counts[self._prefix, kind] += 1
        number = f"{self._prefix}.{self._counts[self._prefix, kind]}".removeprefix(".")
        if key:
            self._numbers[f"{kind}:{key}"] = number
        return number

    def _line(self, line: Line) -> Iterator[Written]:
        """The formula, what its letters are, its numbers at each place; those that are one everywhere go on from it.

        One that the chapter has told already, of the same quantities, stands with its numbers alone.
        """
        left, right = line.formula.sides
        letters = setting.side(left), setting.side(right)
        where = [*self._where(line)]
        known = None if where else self._told.get((self._prefix, line.formula))
        number = known or self._numbered("eq", line.key)
        self._told[self._prefix, line.formula] = number
        if known and line.key:
            self._numbers[f"eq:{line.key}"] = known
        places = line.places[: 1 if self.depth == SHORT else None]
        found = [self._numbers_of(line, place) for place in places]
        own = {plain(setting.side(_indexed(left, place.index))) for place in places}
        if own == {plain(letters[0])} and len(set(found)) == 1 and (len(places) > 1 or not places[0].name):
            if known:
                yield Equation((letters[0], *found[0]), lead=tr("by ({number})", number=known))
                return
            yield Equation((*letters, *found[0]), number, key=line.key)
            yield from where
            return
        if not known:
            yield Equation(letters, number, key=line.key)
            yield from where
        for place, parts in zip(places, found, strict=True):
            lead = ", ".join(each for each in (place.name, known and tr("by ({number})", number=known)) if each)
            yield Equation((setting.side(_indexed(left, place.index)), *parts), lead=lead)

    def _numbers_of(self, line: Line, place: Place) -> tuple[Row, ...]:
        """The right side with the numbers of a place, and the result; the result alone where they are one."""
        left, right = line.formula.sides
        given = result_of(left, place.lexicon)
        assert isinstance(given.value, float)
        found = worked(right, place.lexicon, given.value, unit=given.unit, digits=line.digits)
        self.lines.append(Checked(line.formula, place.name, found))
        numbers = _summed(found) if isinstance(right, Over) else setting.side(found.tree, found.shown)
        result = with_unit(found.result, given.unit)
        same = not found.shown or plain(numbers) == plain(result.boxes[0])
        return (*(() if same else (numbers,)), result, *_converted(given))

    def _where(self, line: Line) -> Iterator[Written]:
        """The names that stand for the first time, or for something else than before, with meaning and unit.

        Both projections of a vector stand together.
        """
        lexicon = line.places[0].lexicon
        groups: dict[tuple[str, str], list[str]] = {}
        for key in names(line.formula):
            _, unit, meaning = lexicon[key]
            if meaning and self._explained.get(key) != (meaning, unit):
                for each in _both(key, lexicon):
                    indices = ("", *(place.index for place in line.places))  # of r_i also r_1 and r_2
                    self._explained |= {indexed(each, index): (meaning, unit) for index in indices}
                    groups.setdefault((meaning, unit), []).append(each)
        parts: list[str | Box | Reference] = []
        for k, ((meaning, unit), keys) in enumerate(groups.items()):
            parts.append("; " if k else tr("where") + " ")
            for j, key in enumerate(keys):
                parts += [", "] * bool(j) + [quantity(key)]
            said = meaning if len(keys) == 1 else _of_several(keys, meaning, unit)
            parts += [" – ", *inline(said).parts, *([f", {shown_unit(unit)}"] if unit else [])]
        if not self._turned and _calls(line.formula, "atan2"):
            self._turned = True
            said = tr("$atan2(y, x)$ – angle of the vector with the projections $x$ and $y$ from the $x$ axis")
            parts += ["; " if parts else tr("where") + " ", *inline(said).parts]
        if parts:
            yield Text((*parts, "."), explains=True)


def _calls(node: Node | Statement, function: str) -> bool:
    """Whether a function stands in a formula."""
    own = isinstance(node, Call) and node.function == function
    return own or any(_calls(part, function) for part in parts_of(node))


def _summed(found: Worked) -> Row:
    """The numbers of a sum over an index: of many terms the first ones and the last, for all stand in a table."""
    tree, more = found.tree, "…"
    if isinstance(tree, Sum) and len(tree.terms) > MANY:
        tree = Sum((*tree.terms[:FIRST], (1, Name(more)), tree.terms[-1]))
    return setting.side(tree, {**found.shown, more: Shown(more)})


def _folded(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks; a long table of numbers that leaves half of the page free is folded, but beside another one."""
    for before, block, after in zip((None, *blocks), blocks, (*blocks[1:], None), strict=False):
        if isinstance(block, Table) and len(block.rows) >= LONG and 2 * (wide := _width(block)) <= ACROSS:
            others = (each for each in (before, after) if isinstance(each, Table))
            if _numeric(block) and not any(wide + _width(each) <= ACROSS for each in others):
                yield folded(block, 2)
                continue
        yield block


def _capital(head: str) -> str:
    """The head of a column, words of the language in force with a capital.

    >>> _capital("least"), _capital("rad"), _capital("$phi$, deg")
    ('Least', 'rad', '$phi$, deg')
    """
    word = WORD.match(head)
    named = head[:1].isascii() and spoken() != "en"  # a name that the spec gives
    return head[:1].upper() + head[1:] if word and word[0] not in unit_names(spoken()) and not named else head


def _numeric(table: Table) -> bool:
    return all(numeric([inline(cell) for cell in column]) for column in zip(*table.rows, strict=True))


def _width(table: Table) -> float:
    """About how wide a table is in small letters [mm]."""
    columns = zip(table.head, *table.rows, strict=True)
    return sum(most(asked(inline(cell)) for cell in column).least * SMALL + CELL for column in columns)


def _both(key: str, lexicon: Lexicon) -> Iterator[str]:
    """A name; of a projection on x or y both, if the other one means the same."""
    said = lexicon[key]
    others = {
        f"{key[:k]}{'y' if letter == 'x' else 'x'}{key[k + 1 :]}" for k, letter in enumerate(key) if letter in "xy"
    }
    same = (o for o in others if o in lexicon and (lexicon[o].meaning, lexicon[o].unit) == (said.meaning, said.unit))
    yield from sorted((key, *same))


def _of_several(keys: Sequence[str], meaning: str, unit: str) -> str:
    """What names mean that have one meaning; those that differ by the axis alone are the parts of a vector."""
    if len({re.sub("[xy]", "x", key) for key in keys}) > 1:
        return several(meaning)
    vector = possessive(meaning)
    if not vector:
        return meaning
    if unit in LENGTHS:
        return tr("coordinates of the {vector}", vector=vector)
    return tr("projections of the {vector}", vector=vector)


def _indexed(node: Node, index: str) -> Node:
    """The node with this index in place of the i at the end of indices; without one as it is."""
    if isinstance(node, Name):
        return Name(indexed(node.key, index))
    return mapped(node, lambda part: _indexed(part, index))


def indexed(key: str, index: str) -> str:
    """A name with this index in place of the i at its end; without one as it is.

    >>> indexed("r_ai", "2"), indexed("W_i^{*}", "1"), indexed("x_{min,i}", "2"), indexed("phi", "1")
    ('r_a2', 'W_1^{*}', 'x_{min,2}', 'phi')
    """
    return COUNTER.sub(lambda found: (found[1] or "") + index, key) if index else key


def _converted(given: Given) -> tuple[Row, ...]:
    """The result in the unit that is asked for in place of its own."""
    unit, factor = printed_as(given.unit)
    assert isinstance(given.value, float)
    return (with_unit(significant(given.value * factor, RESULT), unit),) if unit != given.unit else ()


def answers(blocks: Iterable[Block]) -> Iterator[Block]:
    """What formulas give, in a table a part of the chapter; its own tables stay, all else goes."""
    waiting: list[Line] = []
    title: list[Block] = []
    for block in [*blocks, Heading("")]:
        match block:
            case Heading(_, level):
                if waiting:
                    yield from (*title, _answered(waiting))
                    waiting, title = [], []
                title = [*(each for each in title if isinstance(each, Heading) and each.level < level), block]
            case Line() if isinstance(block.formula.sides[0], Name):
                waiting.append(block)
            case Table():
                yield from title
                title = []
                yield block


def _answered(lines: Sequence[Line]) -> Table:
    """The values of formulas at their places; places with an index are rows of their own."""
    names = dict.fromkeys(place.name for line in lines for place in line.places)
    rows = []
    for line in lines:
        for index in dict.fromkeys(place.index for place in line.places):
            places = [place for place in line.places if place.index == index]
            left = line.formula.sides[0]
            assert isinstance(left, Name)
            given = places[0].lexicon[left.key]
            found = {place.name: f"${_result(line, place)}$" for place in places}
            unit = shown_unit(printed_as(given.unit)[0])
            rows.append(
                (f"${indexed(left.key, index)}$", given.meaning, unit, *(found.get(name, "") for name in names))
            )
    values = [name or tr("Value") for name in names]
    return Table(tr("Results"), (tr("Designation"), tr("Quantity"), tr("Unit"), *values), tuple(rows))


def _result(line: Line, place: Place) -> str:
    """What a line gives at a place, as it is printed in its unit."""
    left, right = line.formula.sides
    given = result_of(left, place.lexicon)
    assert isinstance(given.value, float)
    found = worked(right, place.lexicon, given.value, unit=given.unit, digits=line.digits)
    unit, factor = printed_as(given.unit)
    return found.result if unit == given.unit or not float(found.result) else significant(given.value * factor, RESULT)


def _referred(block: Written, numbers: Mapping[str, str]) -> Written:
    """The block with references in its texts as numbers."""
    match block:
        case Points(items):
            return Points(tuple(_referring(item, numbers) for item in items))
        case Grid(caption, head, rows):
            return Grid(caption, head, tuple(tuple(_referring(cell, numbers) for cell in row) for row in rows))
        case Text():
            return _referring(block, numbers)
    return block


def _referring(text: Text, numbers: Mapping[str, str]) -> Text:
    parts: list[str | Box | Reference] = []
    for part in text.parts:
        if not isinstance(part, str):
            parts.append(part)
            continue
        for k, piece in enumerate(REFERENCE.split(part)):
            parts += [Reference(piece, numbers[piece]) if k % 2 else piece] if piece else []
    return Text(tuple(parts), text.explains)


def drawn(figure: Figure) -> Drawing:
    """The picture in its width, as high as it needs within its size."""
    drawing = Drawing(*figure.size, plain_text(inline(figure.caption)))
    figure.draw(drawing, Rectangle(0.0, 0.0, *figure.size))
    return trimmed(drawing)


def shown_unit(unit: str) -> str:
    """A unit as it stands after a number; of an angle the sign of degrees."""
    return "°" if unit == "deg" else tr_unit(unit)


def with_unit(digits: str, unit: str) -> Row:
    """A result with its unit."""
    number = printed(Shown(digits, unit == "deg"))
    return Row((number,)) if unit in ("", "deg") else Row((number, Gap(), Word(tr_unit(unit))))


def inline(text: str) -> Text:
    """A text with its formulas between ``$``."""
    if "$" not in text:
        return Text((text,) if text else ())
    from tmmcalc.report.formula.syntax import read

    parts = [setting.statement(read(part)) if k % 2 else part for k, part in enumerate(text.split("$"))]
    return Text(tuple(part for part in parts if part != ""))
