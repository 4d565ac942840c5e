"""``[[loads]]``: technological forces and moments on the links, each with its law and where it acts."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.linkage.tables.joints import Place
from tmmcalc.spec.identifiers import Name, PositionLabel
from tmmcalc.spec.quantities import Angle, Force, InputDistance, Moment, Number, Quantity, Size
from tmmcalc.spec.table import Table

LoadName = Annotated[str, Name("load")]
Factor = Annotated[float, Number("a load factor", "1.2", at_least=0)]
Coefficient = Annotated[float, Number("a coefficient", "1.5")]
Part = Annotated[float, Number("a part of the stroke", "0.1", at_least=0, at_most=1)]
Area = Annotated[float, Quantity("area", at_least_zero=True, nonzero=True)]
Delay = Annotated[float, Quantity("angle", at_least_zero=True)]
Period = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]
Pressure = Annotated[float, Quantity("pressure", at_least_zero=True)]
Viscous = Annotated[float, Quantity("damping", "torsional damping", at_least_zero=True)]
Quadratic = Annotated[float, Quantity("quadratic damping", "torsional quadratic damping", at_least_zero=True)]


class PolynomialTable(Table):
    """A polynomial of the angle from the beginning of the load's window: c0, c1, ... in SI per rad^k."""

    force: list[Coefficient] | None = Field(default=None, min_length=1, description="Coefficients of a force.")
    moment: list[Coefficient] | None = Field(default=None, min_length=1, description="Coefficients of a moment.")


class LoadCurveTable(Table):
    """Values at given abscissae, in the table itself or in a file."""

    of: Literal["angle", "position", "displacement", "stroke"] = Field(
        default="angle",
        description="What x is: the angle from position 0 along the motion, numbers of positions, the displacement of "
        "an output from its lesser extreme, or that displacement from 0 to 1.",
    )
    x: list[InputDistance] | None = Field(
        default=None,
        min_length=2,
        description="Abscissae, ascending (default: equal steps over the period or the stroke; positions 0, 1, ...).",
    )
    force: list[Force] | None = Field(default=None, min_length=2, description="Values of a force.")
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Values of a moment.")
    file: str | None = Field(
        default=None,
        description="CSV file of two columns with a header name[unit], in place of x and the values; "
        "its path counts from the spec.",
    )
    interpolation: Literal["linear", "pchip"] = Field(
        default="linear", description="Straight lines, or a smooth monotone curve."
    )
    output: str | None = Field(default=None, description="Output whose displacement x is (default: the first).")
    period: Period | None = Field(default=None, description="Angle after which the values repeat (default: one turn).")


class StrokeTable(Table):
    """Pressures over one stroke of a piston."""

    x: list[Part] = Field(
        min_length=2, description="Distances of the piston from the closed end, from 0 to 1 or from 1 to 0."
    )
    p: list[Pressure] = Field(min_length=2, description="Absolute pressure at each x.")


class IndicatorTable(Table):
    """An indicator diagram: the pressure in a cylinder, stroke by stroke."""

    diameter: Size | None = Field(default=None, description="Diameter of the piston.")
    area: Area | None = Field(default=None, description="Area of the piston, in place of its diameter.")
    back_pressure: Pressure = Field(default=101325.0, description="Absolute pressure on the other side of the piston.")
    delay: Delay = Field(
        default=0.0,
        description="The first stroke begins at the first dead centre at the closed end from this angle on.",
    )
    strokes: list[StrokeTable] = Field(
        description="Two or four strokes in the order of the motion; the first leads away from the closed end."
    )


class LoadTable(Table):
    """A force at a point of a link, or a moment on it, by exactly one law."""

    name: LoadName | None = Field(default=None, description='Name, unique (default: "Q<link>").')
    link: int = Field(ge=1, description="Link that the load acts on.")
    point: Place | None = Field(default=None, description="Where a force acts: the name of a point, or [x, y].")
    direction: Angle = Field(default=0.0, description="Direction of a positive force, from the x axis.")
    axes: int = Field(default=0, ge=0, description="Link in whose axes the direction is given; 0: the fixed axes.")
    against: int = Field(default=0, ge=0, description="Link that takes the opposite load.")
    role: Literal["resistance", "drive"] = Field(
        default="resistance", description="Whether the load is a useful resistance or drives the machine."
    )
    factor: Factor = Field(default=1.0, description="Load factor.")
    force: Force | None = Field(default=None, description="Constant force.")
    moment: Moment | None = Field(default=None, description="Constant moment.")
    polynomial: PolynomialTable | None = Field(default=None, description="Polynomial of the angle.")
    viscous: Viscous | None = Field(
        default=None, description="Resistance -c v; a bare number is of a force if there is a point, else of a moment."
    )
    quadratic: Quadratic | None = Field(
        default=None,
        description="Resistance -c v|v|; a bare number is of a force if there is a point, else of a moment.",
    )
    table: LoadCurveTable | None = Field(default=None, description="Values at given abscissae.")
    indicator: IndicatorTable | None = Field(default=None, description="Indicator diagram of a cylinder.")
    stroke: Literal["working", "idle"] | None = Field(default=None, description="Stroke on which the load acts.")
    output: str | None = Field(default=None, description="Output whose stroke it is (default: the first).")
    between: list[InputDistance] | None = Field(
        default=None, min_length=2, max_length=2, description="From and to, counted from position 0 along the motion."
    )
    positions: list[PositionLabel] | None = Field(
        default=None, min_length=2, max_length=2, description="From and to, as numbers or labels of positions."
    )
