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

    force: list[Coefficient] | None = Field(
        default=None, min_length=1, description="Coefficients c0, c1, c2, ... of a force, in N/rad^k."
    )
    moment: list[Coefficient] | None = Field(
        default=None, min_length=1, description="Coefficients c0, c1, c2, ... of a moment, in N*m/rad^k."
    )


class LoadCurveTable(Table):
    """Values at given abscissae, in the table itself or in a file."""

    of: Literal["angle", "position", "displacement", "stroke"] = Field(
        default="angle",
        description='What `x` is: `"angle"` from position 0 along the motion, `"position"` numbers, `"displacement"` '
        'of an output from its lesser extreme, `"stroke"` that displacement from 0 to 1.',
    )
    x: list[InputDistance] | None = Field(
        default=None,
        min_length=2,
        description="Abscissae, ascending (default: equal steps of the period, the positions 0, 1, 2 ..., or the "
        "stroke from 0 to 1).",
    )
    force: list[Force] | None = Field(default=None, min_length=2, description="Values of a force, one for each `x`.")
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Values of a moment, one for each `x`.")
    file: str | None = Field(
        default=None,
        description="CSV file of two columns with a header `name[unit]`, in place of `x` and the values; "
        "its path counts from the folder of the spec.",
    )
    interpolation: Literal["linear", "pchip"] = Field(
        default="linear", description='`"linear"`: straight lines, or `"pchip"`, a smooth monotone curve.'
    )
    output: str | None = Field(default=None, description="Output whose displacement `x` is (default: the first).")
    period: Period | None = Field(
        default=None,
        description='Angle after which the values repeat (default: 360 deg); `"720 deg"` for a four-stroke engine.',
    )


class StrokeTable(Table):
    """Pressures over one stroke of a piston."""

    x: list[Part] = Field(
        min_length=2, description="Distances of the piston from the closed end, from 0 to 1 or from 1 to 0."
    )
    p: list[Pressure] = Field(min_length=2, description="Absolute pressure at each `x`.")


class IndicatorTable(Table):
    """An indicator diagram: the pressure in a cylinder, stroke by stroke."""

    diameter: Size | None = Field(default=None, description="Diameter of the piston; or `area`.")
    area: Area | None = Field(default=None, description="Area of the piston, in place of its diameter.")
    back_pressure: Pressure = Field(default=101325.0, description="Absolute pressure on the other side of the piston.")
    delay: Delay = Field(
        default=0.0,
        description="The first stroke begins at the first dead centre at the closed end from this angle on.",
    )
    strokes: list[StrokeTable] = Field(
        description="Two or four strokes in the order of the motion, the first leads away from the closed end: "
        '`[{ x = [0, 0.1, 1], p = ["5 MPa", "2 MPa", "0.2 MPa"] }, ...]`.'
    )


class LoadTable(Table):
    """A force at a point of a link, or a moment on it, by exactly one law."""

    name: LoadName | None = Field(
        default=None, description="Unique name (default: `Q<link>`); a second load on link 5 is `Q5'`."
    )
    link: int = Field(ge=1, description="Link that the load acts on.")
    point: Place | None = Field(
        default=None,
        description="Where a force acts: the name of a point of the link, or `[x, y]` in its axes; a moment has none.",
    )
    direction: Angle = Field(default=0.0, description="Direction of a positive force, from the x axis.")
    axes: int = Field(
        default=0,
        ge=0,
        description="Link in whose axes the direction is given, so that it turns with it; 0: the fixed axes.",
    )
    against: int = Field(default=0, ge=0, description="Link that takes the opposite load, in the same line.")
    role: Literal["resistance", "drive"] = Field(
        default="resistance",
        description='Whether the load is a useful `"resistance"` or a `"drive"` in the balance of work.',
    )
    factor: Factor = Field(default=1.0, description="Load factor.")
    force: Force | None = Field(default=None, description='Constant force, `"1500 N"`.')
    moment: Moment | None = Field(default=None, description='Constant moment, `"40 N*m"`.')
    polynomial: PolynomialTable | None = Field(
        default=None,
        description="`{ force = [c0, c1, c2] }` (or `moment`): c0 + c1 theta + c2 theta^2 ..., numbers in SI per "
        "rad^k; theta counts from the beginning of the window.",
    )
    viscous: Viscous | None = Field(
        default=None,
        description='Resistance -c v of the point along the direction, `"20 N*s/m"`; '
        'or -c omega of the link, `"0.5 N*m*s/rad"`. A bare number is a force if there is a `point`, '
        "else a moment.",
    )
    quadratic: Quadratic | None = Field(
        default=None,
        description='Resistance -c v abs(v) of the point along the direction, `"3.5 N*s^2/m^2"`; '
        'or of the link, `"0.02 N*m*s^2/rad^2"`. A bare number is a force if there is a `point`, else a '
        "moment.",
    )
    table: LoadCurveTable | None = Field(default=None, description="Values at given abscissae, of a force or a moment.")
    indicator: IndicatorTable | None = Field(default=None, description="Indicator diagram of a cylinder.")
    stroke: Literal["working", "idle"] | None = Field(
        default=None, description='`"working"` or `"idle"`: the load acts on that stroke of an output.'
    )
    output: str | None = Field(default=None, description="Output whose stroke it is (default: the first).")
    between: list[InputDistance] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description='From the first angle to the second, counted from position 0 along the motion, `["30 deg", "180 '
        'deg"]`; `["300 deg", "60 deg"]` goes over position 0. Lengths for a driven slider.',
    )
    positions: list[PositionLabel] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description="From one position of the grid to another, by numbers or labels, `[2, 12]`; "
        '`"6\'"` is an added one.',
    )
