"""What a page lets be tried by hand: a point in a plane of two inputs, and sizes that follow from it by formulas.

Formulas are those of the note (`tmmcalc.report.formula.carried`), in their units: angles in rad, all else in the units
in which it is printed.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from tmmcalc.core.plane import Plane
from tmmcalc.report.formula.carried import Step

Kind = Literal["strict", "tolerated", "piece"]  # admissible, admissible with a flaw, admissible but apart


class Region(NamedTuple):
    """A part of the plane."""

    kind: Kind
    edge: Plane  # (n,) closed, first input + i second


class Curve(NamedTuple):
    """A line of the plane: its number, what is constant along it, and its value."""

    number: str
    title: str
    value: float
    at: Plane  # (n,)


class Point(NamedTuple):
    """A point of the plane that has a name."""

    name: str
    title: str
    at: complex


class Shown(NamedTuple):
    """A quantity that is told: its name in the formulas, what it is, its unit, and the least that it should be."""

    name: str
    meaning: str
    unit: str
    least: str | float | None = None  # in the units of the formulas, or the name of another quantity
    where: str = ""  # a quantity that is not negative where this one has a sense; empty: everywhere


class Trial(NamedTuple):
    """A plane with its point; all texts in the language in force."""

    name: str
    title: str
    inputs: tuple[str, str]  # names in the formulas
    start: complex
    box: tuple[complex, complex]  # lower left and upper right corner of what is shown
    regions: tuple[Region, ...]
    curves: tuple[Curve, ...]
    points: tuple[Point, ...]
    given: dict[str, float]  # what the formulas need beside the inputs
    steps: tuple[Step, ...]  # in an order in which each needs those before it
    shown: tuple[Shown, ...]
