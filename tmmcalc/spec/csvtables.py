"""The columns of a CSV table that a spec names: what its header says of them, numbers of theirs in SI.

A table that a command has printed, or left in the output folder, is read as it is: the labels of its positions are
passed over, and of more than two columns ``columns`` names two, as ``--columns`` does.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from tmmcalc.spec.phrases import either, nearest, show
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.units import UnitError, dimension_of, parse

_DECIMAL = re.compile(r"[+-]?(\d++(\.\d*+)?|\.\d++)([eE][+-]?\d++)?", re.ASCII)
_NUMBER = re.compile(r"[+\N{MINUS SIGN}-]?[\d.,]*\d[.,]?([eE][+-]?\d+)?", re.ASCII)
_PLAIN = ("", "-", "1")  # how a header says that
LABELS = "i"  # header of the labels of positions
CHOICE = "columns"  # the key that names columns of a file
_COUNTED = {1: "one column", 2: "two columns"}


class FileError(Exception):
    """A fault of a file: its line, what is wrong, what to write instead."""

    def __init__(self, line: int, message: str, remedy: str) -> None:
        self.line, self.message, self.remedy = line, message, remedy
        super().__init__(message)


class ByName(NamedTuple):
    """Columns that go by their names, in any order, and may do without a header; each row becomes a pair."""

    find: Callable[[Sequence[str]], tuple[tuple[int, int], str] | None]  # where x and value stand, the key of the value
    without: tuple[str, str]  # header of a file that has none
    rule: str  # which columns there are
    remedy: str
    plain: Mapping[str, tuple[str, str]]  # keys whose values have no unit: the rule, and the remedy


class Form(NamedTuple):
    """What a table is of: its words, the key and the dimensions of x, the dimensions of the values."""

    noun: str
    key: str
    x: tuple[str, ...]  # an empty word among them: plain numbers
    values: tuple[str, ...]
    example: str
    turns: bool = False  # whether x, an angle, says that it is one: it may be beyond a turn
    counted: Mapping[str, str] = {}  # by what the table says that x is ``of``: plain numbers, and which
    by_name: ByName | None = None
    instead: tuple[str, ...] = ()  # keys of the table that the file stands in place of; empty: x and the values

    @property
    def keys(self) -> set[str]:
        """Keys of the table that the file stands in place of."""
        return {*self.instead} or {self.key, *self.values}


class Column(NamedTuple):
    """The unit of a column and its dimension, both empty for plain numbers."""

    unit: str
    dimension: str

    def is_of(self, dimensions: tuple[str, ...]) -> bool:
        """Whether it is of one of the dimensions; an unknown unit is of none."""
        return self.dimension in dimensions and bool(self.unit) == bool(self.dimension)

    def read(self, cell: str) -> float:
        """Return a number of the column in SI; raise UnitError if it is none."""
        text = cell.replace("−", "-")
        if not _DECIMAL.fullmatch(text):
            comma = re.fullmatch(r"([+-]?\d+),(\d+)", text)
            remedy = f"write a decimal point: {comma[1]}.{comma[2]}" if comma else "write a number without its unit"
            raise UnitError(f"{show(cell)} is not a number", remedy)
        return parse(f"{text} {self.unit}", self.dimension) if self.unit else Number("a number", "1").read(float(text))


class Columns(NamedTuple):
    """The columns of x and of the values, where they stand in a row, and the key of the values in the table."""

    x: Column
    y: Column
    order: tuple[int, int]
    key: str
    width: int = 2  # number of all columns

    def pair(self, row: Sequence[str]) -> tuple[float, float]:
        """Return x and the value of a row in SI; raise UnitError if there are none."""
        if len(row) != self.width:
            raise UnitError(
                f"{len(row)} value{'s' if len(row) != 1 else ''} in a table of "
                f"{_COUNTED.get(self.width, f'{self.width} columns')}",
                "write x, value" if self.width == 2 else "write a value for each column",
            )
        first, second = (row[place] for place in self.order)
        return self.x.read(first), self.y.read(second)

    def negative(self, row: Sequence[str]) -> UnitError:
        """What is wrong with a row whose x is negative."""
        return UnitError(f"{show(row[self.order[0]])} is negative; x counts from 0", "write it without the minus")


def cells(line: str, separator: str) -> list[str]:
    """The cells of a line without blanks and quotes around them."""
    return [cell.strip().strip('"').strip() for cell in line.split(separator)]


def are_numbers(row: Sequence[str]) -> bool:
    """Whether a row holds numbers alone, with a point or a comma."""
    return all(_NUMBER.fullmatch(cell) for cell in row)


def columns_of(header: Sequence[str], of: str, line: int, form: Form, chosen: str = "") -> Columns:
    """Return the columns of x and of the values; raise FileError if the header does not name them.

    ``chosen`` names the column of the values, or those of x and of the values.
    """
    two = _two(header, of, line, form, chosen)
    order, key = ((0, 1), "") if form.by_name is None else _by_name([header[k] for k in two], line, form.by_name)
    order = two[order[0]], two[order[1]]
    first, second = (header[place] for place in order)
    x, y = _column(first), _column(second)
    if of in form.counted and x.unit:
        what = form.counted[of]
        raise FileError(line, f"{show(first)} has a unit; x are {what}", "write a name without unit, such as i")
    if of not in form.counted and not x.is_of(form.x):
        raise _not_of(first, form.x, line, form)
    if form.by_name is not None and key in form.by_name.plain and y.unit:
        what, remedy = form.by_name.plain[key]
        raise FileError(line, f"{show(second)} has a unit; {what}", remedy)
    if not y.is_of(form.values):
        raise _not_of(second, form.values, line, form)
    return Columns(x, y, order, key or y.dimension, len(header))


def _two(header: Sequence[str], of: str, line: int, form: Form, chosen: str) -> tuple[int, int]:
    """Where the two columns stand: those that are chosen, or all that there are beside labels."""
    if chosen:
        names = [_found(header, name, line) for name in chosen.split(",")]
        if len(names) == 1:
            fits = (k for k, cell in enumerate(header) if k != names[0] and _may_be_x(cell, of, form))
            names.insert(0, next(fits, 0 if names[0] else 1))
        if len(names) != 2 or names[0] == names[1]:
            what = "one column twice" if len(names) == 2 else f"{len(names)} columns"
            rule = f"{CHOICE} = {show(chosen)} names {what}; a table of {form.noun} has two, {form.key} and the values"
            raise FileError(line, rule, f"write {CHOICE} = {_suggested(header, of, form)}")
        return names[0], names[1]
    kept = [k for k, cell in enumerate(header) if len(header) != 3 or k or cell != LABELS]
    if len(kept) != 2:
        count = f"{len(header)} column{'s' if len(header) != 1 else ''}"
        remedy = form.example
        if len(header) > 2 and form.by_name is None:  # of a law of motion the names say it
            remedy += f", or choose two: {CHOICE} = {_suggested(header, of, form)}"
        raise FileError(line, f"{count}; a table of {form.noun} has two, {form.key} and the values", remedy)
    return kept[0], kept[1]


def _suggested(header: Sequence[str], of: str, form: Form) -> str:
    """The first columns that may be x and the values, as they are chosen."""
    x = next((cell for cell in header if _may_be_x(cell, of, form)), form.key)
    value = next((cell for cell in header if cell != x and _column(cell).is_of(form.values)), header[-1])
    return f'"{_named(x)[0]},{_named(value)[0]}"'


def _found(header: Sequence[str], name: str, line: int) -> int:
    """Where the column of a name stands, with its unit or without."""
    for k, cell in enumerate(header):
        if name.strip() in (cell, _named(cell)[0]):
            return k
    names = [_named(cell)[0] for cell in header]
    close = nearest(name.strip(), names)
    remedy = f"did you mean {show(close)}?" if close else f"there are: {', '.join(names[:20])}"
    raise FileError(line, f"no column is called {show(name.strip())}", remedy)


def _may_be_x(cell: str, of: str, form: Form) -> bool:
    """Whether a column may be that of x; plain numbers of positions are the labels of positions."""
    return cell == LABELS if of == "position" else _column(cell).is_of(form.x)


def _by_name(header: Sequence[str], line: int, named: ByName) -> tuple[tuple[int, int], str]:
    """Where x and the values stand in a row, and the key of the values; raise FileError for names that do not say."""
    names = [_named(cell)[0] for cell in header]
    found = named.find(names)
    if found is None:
        raise FileError(line, f"the columns are {' and '.join(map(show, names))}; {named.rule}", named.remedy)
    return found


def _not_of(name: str, dimensions: tuple[str, ...], line: int, form: Form) -> FileError:
    kinds = either(f"{dimension}s" for dimension in dimensions if dimension)
    plain = ", or of numbers without one" if "" in dimensions else ""
    from tmmcalc.spec.cyrillic import latin_units  # late: only faults need it

    latin = f"{_named(name)[0]}[{latin_units(_named(name)[1])}]"
    known = latin != name and _column(latin).is_of(dimensions)
    remedy = f"write the unit in Latin letters: {latin}" if known else form.example
    return FileError(line, f"{show(name)} is not a column of {kinds} with its unit{plain}", remedy)


def _named(cell: str) -> tuple[str, str]:
    """The name and the unit of a column, either empty where the header has none."""
    name, opened, unit = cell.partition("[") if cell.endswith("]") else (cell, "", "")
    return name.rstrip(), unit.removesuffix("]").strip() if opened else ""


def _column(cell: str) -> Column:
    unit = _named(cell)[1]
    return Column("", "") if unit in _PLAIN else Column(unit, dimension_of(f"1 {unit}") or "")
