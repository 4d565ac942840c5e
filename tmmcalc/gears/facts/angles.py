"""The document of every intermediate quantity of pairs of gears: its formula in letters and with numbers, its value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any, NamedTuple

from tmmcalc.core.quantity import Quantity, quantities
from tmmcalc.gears.facts.meshes import titles
from tmmcalc.gears.letters import LETTER, filled
from tmmcalc.gears.meshing.angles import pair_angles
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

PAIR = "pair"
DIGITS = 9
FUNCTIONS = {"pi", "abs", "sin", "cos", "tan", "asin", "acos", "atan"}


class Row(NamedTuple):
    """One quantity of a pair, a wheel or a point."""

    of: str
    told: Quantity
    value: float
    formula: str  # in letters; empty: none
    numbers: str  # lengths in mm, angles in rad


def angles_document(result: Pairs, title: str, *, everything: bool = False) -> Document:
    """Every pair in the order of a calculation by hand; with ``everything`` one table of all of them."""
    named = [(name, found, list(angle_rows(found))) for name, found in zip(titles(result), result.pairs, strict=True)]
    if everything:
        rows = [(name, row) for name, _, own in named for row in own]
        columns: dict[str, list[Any]] = {
            "pair": [name for name, _ in rows],
            "of": [row.of for _, row in rows],
            "quantity": [row.told.key for _, row in rows],
            "value": [row.value for _, row in rows],
            "meaning": [row.told.meaning for _, row in rows],
            "formula": [row.formula for _, row in rows],
            "numbers": [row.numbers for _, row in rows],
        }
        return Document(title, (), (), View(list(columns), list(columns.values())))
    parts = tuple(Document(name, tuple(_facts(rows))) for name, _, rows in named)
    if len(parts) == 1:
        return Document(title, parts[0].facts)
    return Document(title, parts=parts)


def angle_rows(found: MeshPair) -> Iterator[Row]:
    """The quantities of a pair, then of its wheels, then of the ends of the contact; those that it has not left out."""
    pair = pair_angles(found)
    letters = {**_numbers(pair), "h_a": found.task.rack.addendum, "b": 1e3 * (found.task.face_width or 0.0)}
    for k, wheel in enumerate(pair.wheels, 1):
        letters |= {f"{name}_{k}": value for name, value in _numbers(wheel).items()}
    letters.setdefault("x_2", 0.0)  # of a rack
    yield from _rows(PAIR, pair, letters)
    for wheel in pair.wheels:
        yield from _rows(f"wheel {wheel.wheel}", wheel, letters | _numbers(wheel))
    for point in pair.points:
        yield from _rows(f"point {point.point}", point, letters | _numbers(point))


def _numbers(of: Any) -> dict[str, float]:
    """The numbers of a record by their names, lengths in mm."""
    found = {}
    for name, told in quantities(type(of)).items():
        value = getattr(of, name)
        if isinstance(value, int | float):
            found[told.name] = 1e3 * value if told.unit == "m" else value
    return found


def _rows(of: str, held: Any, letters: dict[str, float]) -> Iterator[Row]:
    for name, told in quantities(type(held)).items():
        value = getattr(held, name)
        if not isinstance(value, int | float):
            continue
        formula = told.source.removeprefix("= ") if told.source.startswith("=") else ""
        if {*LETTER.findall(formula)} - letters.keys() - FUNCTIONS:
            formula = ""  # a rack has not all of its letters
        yield Row(of, told, value, formula, filled(formula, letters))


def _facts(rows: Sequence[Row]) -> Iterator[Fact]:
    """A fact a pair, wheel or point: a line a quantity."""
    for of in dict.fromkeys(row.of for row in rows):
        own = [row for row in rows if row.of == of]
        values = {row.told.key: row.value for row in own}
        yield Fact(of, "\n".join(_line(row) for row in own), {of: values})


def _line(row: Row) -> str:
    name, unit = row.told.name, row.told.unit
    if unit == "m":
        value = f"{number(1e3 * row.value, DIGITS)} mm"
    elif unit == "rad":
        value = f"{number(row.value, DIGITS)} rad = {number(degrees(row.value), DIGITS)} deg"
    else:
        value = number(row.value, DIGITS, 1.0)
    if not row.formula:
        return f"{name} = {value}: {row.told.meaning}"
    return f"{name} = {row.formula} = {row.numbers} = {value}"
