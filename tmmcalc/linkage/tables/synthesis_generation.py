"""The kinds of ``[synthesis]`` that generate a path, a function or a motion, exactly or in the least squares."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole, Within
from tmmcalc.spec.quantities import Angle, Number, Point, Quantity, Size
from tmmcalc.spec.table import Table

MECHANISMS = ("four_bar", "slider_crank")

Mechanism = Annotated[str, Known("linkage", MECHANISMS)]
Spacing = Annotated[str, Known("spacing", ("chebyshev", "equal"))]
Count = Annotated[int, Whole("a number of points", 3, 500)]
Output = Annotated[float, Quantity("angle", "length")]
Abscissa = Annotated[float, Number("a number", "1.5")]
Pair = Annotated[list[Abscissa], Field(min_length=2, max_length=2)]
Turn = Annotated[float, Within("angle", "deg", math.pi / 180, -360, 360)]
Ratio = Annotated[float, Number("a ratio of lengths", "20", above=1, at_most=1e6)]


class FunctionTable(Table):
    """A function generator: an expression or table that is scaled to ranges, or inputs and outputs themselves."""

    mechanism: Mechanism = Field(
        default="four_bar",
        description='`"four_bar"`: the output is the rocker\'s angle; `"slider_crank"`: the slider\'s place.',
    )
    expression: str | None = Field(default=None, description='Formula y(x), such as `"log(x)"`.')
    range: Annotated[list[Abscissa], Field(min_length=2, max_length=2)] | None = Field(
        default=None, description="Interval of x over which the expression is taken, such as `[1, 2]`."
    )
    points: Count | None = Field(default=None, description="Number of precision points of an expression (default: 3).")
    spacing: Spacing = Field(
        default="chebyshev",
        description='Spacing of the precision points: `"chebyshev"`, or `"equal"`, which includes the ends.',
    )
    table: Annotated[list[Pair], Field(min_length=3, max_length=500)] | None = Field(
        default=None, description="In place of an expression: pairs `[[x, y], ...]`, x ascending."
    )
    input_range: Turn | None = Field(
        default=None, description="Turn of the crank while x runs over its range; negative the other way."
    )
    output_range: Output | None = Field(
        default=None,
        description="Turn of the rocker, or travel of the slider, from the first y to the last; "
        "negative the other way.",
    )
    inputs: list[Angle] | None = Field(
        default=None, description="In place of a formula or table and its ranges: angles of the crank, from the first."
    )
    outputs: list[Output] | None = Field(default=None, description="With `inputs`: the outputs there, from the first.")
    input_start: Angle | None = Field(default=None, description="Angle of the crank where x begins (default: free).")
    output_start: Output | None = Field(
        default=None, description="Angle of the rocker, or place of the slider, where x begins (default: free)."
    )
    frame: Size = Field(default=0.1, description="Length of the frame of a four-bar.")


class PathTable(Table):
    """A path generator: points of the coupler point, with the crank's angles or without."""

    mechanism: Mechanism = Field(default="four_bar", description='The linkage: `"four_bar"` or `"slider_crank"`.')
    points: list[Point] = Field(
        min_length=2, max_length=500, description="Points `[[x, y], ...]` in the order of the motion."
    )
    timing: list[Angle] | None = Field(default=None, description="Angles of the crank at the points, from the first.")
    region: Annotated[list[Point], Field(min_length=2, max_length=2)] | None = Field(
        default=None, description="Two corners of a rectangle in which the fixed pivots stand."
    )
    full_turn: bool = Field(default=False, description="Whether a crank that does not turn fully is a defect.")
    largest_ratio: Ratio = Field(
        default=20.0, description="Ratio of the longest to the shortest link; above it is a defect."
    )


class MotionSynthesisTable(Table):
    """A motion generator: poses of a body on the coupler."""

    mechanism: Mechanism = Field(default="four_bar", description='The linkage: `"four_bar"` or `"slider_crank"`.')
    points: list[Point] = Field(
        min_length=2,
        max_length=500,
        description="Places `[[x, y], ...]` of a point of the body in the order of the motion.",
    )
    angles: list[Angle] = Field(min_length=2, max_length=500, description="Angles of the body at the points.")
    region: Annotated[list[Point], Field(min_length=2, max_length=2)] | None = Field(
        default=None, description="Two corners of a rectangle in which the fixed pivots stand."
    )
    full_turn: bool = Field(default=False, description="Whether a crank that does not turn fully is a defect.")
    largest_ratio: Ratio = Field(
        default=20.0, description="Ratio of the longest to the shortest link; above it is a defect."
    )
