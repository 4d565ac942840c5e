"""What a page lets be tried by hand: a point in a plane of two inputs, and sizes that follow from it by formulas.

Formulas are those of the note (`tmmcalc.report.formula.carried`), in their units: angles in rad, all else in the units
in which it is printed.
"""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

from tmmcalc.core.plane import Plane
from tmmcalc.report.formula.carried import Root, Step

Kind = Literal["strict", "tolerated"]  # admissible, admissible with a flaw


class Region(NamedTuple):
    """A part of the plane."""

    kind: Kind
    edge: Plane  # (n,) closed, first input + i second
    apart: bool = False  # from the main part of its kind


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


class Condition(NamedTuple):
    """What has to hold: a formula that is not negative, and what is told where it is or has no value."""

    formula: Any
    text: str
    needed: bool = True  # for all that comes after it: nothing is drawn without it


class Piece(NamedTuple):
    """A part of a curve: where a parameter takes a point on its way from one end to the other."""

    parameter: str
    start: Any
    end: Any
    steps: tuple[Step, ...]  # which need the parameter
    x: Any
    y: Any


class Toothed(NamedTuple):
    """A body with teeth, whose centre is its origin: half a tooth left of +Y, from the middle of the gap to its own."""

    half: tuple[Piece, ...]
    worked: Piece  # what of the flank touches others; nothing where its end is before its start
    beyond: str  # told where the half tooth reaches beyond its middle: nothing is drawn then
    count: Any
    turn: Any
    x: Any
    y: Any
    tone: int


class Drawn(NamedTuple):
    """A mark of `tmmcalc.report.moving`, or a named point: its places by formulas."""

    kind: Literal["line", "bar", "axis", "pitch", "base", "dot", "number"]
    places: tuple[tuple[Any, Any], ...]
    size: Any = 0.0  # of circles the radius
    tone: int = 0
    name: str = ""
    side: int = 0  # of its name: right above, or with -1 left below
    there: Any = 0.0  # where it is not negative


class Sketch(NamedTuple):
    """What is drawn of the point of a trial, in the units of its formulas, around a place that stays in the middle."""

    title: str
    middle: tuple[Any, Any]
    reach: float  # that is shown above it, and below
    bodies: tuple[Toothed, ...]
    marks: tuple[Drawn, ...]


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
    steps: tuple[Step | Root, ...]  # in an order in which each needs those before it
    shown: tuple[Shown, ...]
    conditions: tuple[Condition, ...]
    sketch: Sketch
