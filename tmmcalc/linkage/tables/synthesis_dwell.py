"""``[synthesis.dwell]``: a six-bar of class IV whose slider or rocker stands for a part of the crank's turn."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole, Within
from tmmcalc.spec.quantities import Angle, Number, Quantity, Size
from tmmcalc.spec.table import Table

_ANGLE = ("angle", "deg", math.pi / 180)

Dwelling = Annotated[float, Within(*_ANGLE, 1, 300)]
Turn = Annotated[float, Within(*_ANGLE, 0.1, 359.9)]
Swing = Annotated[float, Within(*_ANGLE, 0.1, 179.9)]
Stroke = Annotated[float, Within(*_ANGLE, 1, 359)]
Part = Annotated[float, Number("a part of l_OB", "0.3", above=0, at_most=1000)]
Place = Annotated[float, Number("a part of l_OB", "-0.6", at_least=-1000, at_most=1000)]
Fraction = Annotated[float, Number("a part of the dwell", "0.5", at_least=-10, at_most=10)]
Weight = Annotated[float, Number("a weight", "1", at_least=0, at_most=1e9)]
Kind = Annotated[str, Known("output", ("slider", "rocker"))]
Side = Annotated[str, Known("side", ("left", "right"))]
Sense = Annotated[str, Known("sense", ("ccw", "cw"))]
Working = Annotated[str, Known("stroke", ("towards", "away"))]
Resistance = Annotated[float, Quantity("force", "moment", at_least_zero=True, nonzero=True)]
Reverse = Annotated[int, Whole("k", 0, 1)]
Steps = Annotated[int, Whole("a number of steps", 3, 500)]
Evaluations = Annotated[int, Whole("a number of evaluations", 0, 100_000)]
Generations = Annotated[int, Whole("a number of generations", 1, 10_000)]
Population = Annotated[int, Whole("a number of linkages", 10, 10_000)]
_PAIR = Field(min_length=2, max_length=2)
Angles = Annotated[list[Angle], _PAIR]
Numbers = Annotated[list[Part], _PAIR]
Fractions = Annotated[list[Fraction], _PAIR]


class PositionsTable(Table):
    """Parameters of the three-position synthesis; lengths are parts of l_OB."""

    phi12: Turn | None = Field(default=None, description="Turn of the crank from position 1 to 2.")
    psi0: Angle | None = Field(default=None, description="Angle of B -> C in position 1, O -> B at dwell being 0.")
    psi12: Angle | None = Field(default=None, description="Turn of bar BC from position 1 to 2.")
    psi13: Angle | None = Field(default=None, description="Turn of bar BC from position 1 to 3.")
    CB: Part | None = Field(default=None, description="Length of bar 3, a part of l_OB.")
    CD: Part | None = Field(default=None, description="Side of the coupler, a part of l_OB.")
    alpha: Angle | None = Field(default=None, description="From C -> A to C -> D, counter-clockwise.")


class DwellLengthsTable(Table):
    """A linkage by its lengths, parts of l_OB; DE and BE follow from three places of D."""

    OA: Part = Field(description="Length of the crank, a part of l_OB.")
    AC: Part = Field(description="Length of the coupler, a part of l_OB.")
    CB: Part = Field(description="Length of bar 3, a part of l_OB.")
    CD: Part = Field(description="Side of the coupler, a part of l_OB.")
    alpha: Angle = Field(description="From C -> A to C -> D, counter-clockwise.")
    phi0: Angle = Field(description="Angle of the crank in position 1, O -> B at dwell being 0.")
    phi12: Turn | None = Field(
        default=None, description="Turn of the crank from position 1 to 2 (default: half of the dwell)."
    )
    side: Side = Field(default="left", description='`"left"` or `"right"`: side of A -> B at dwell on which C is.')


class DwellWeightsTable(Table):
    """Weights of the criteria; lengths are parts of l_OB, the resistance is 1."""

    f1: Weight = Field(default=100.0, description="Weight of max abs(S) over the dwell against the stroke.")
    f2: Weight | None = Field(default=None, description="Weight of l_OB/l_OA, the size (default: 1, of a rocker 0).")
    f3: Weight = Field(default=1.0, description="Weight of max tan of the pressure angle delta over the turn.")
    f4: Weight = Field(
        default=1.0,
        description="Weight of max R35^2 + max R45^2 of the bars over the working stroke, for a unit resistance.",
    )
    f5: Weight = Field(
        default=0.1, description="Weight of max R35^2 + max R45^2 of the bars over the idle stroke, likewise."
    )


class RangesTable(Table):
    """Ranges of the parameters that are sought."""

    phi12_part: Fractions | None = Field(default=None, description="Range of phi12/phi_B (default: 0.4 to 0.6).")
    psi0: Angles | None = Field(default=None, description="Range of `psi0` (default: 18 to 162 deg).")
    psi13: Angles | None = Field(default=None, description="Range of `psi13` (default: -162 to -18 deg).")
    psi12_part: Fractions | None = Field(default=None, description="Range of psi12/psi13 (default: 0.4 to 0.6).")
    CB: Numbers | None = Field(default=None, description="Range of `CB` (default: 0.1 to 1.5).")
    CD: Numbers | None = Field(default=None, description="Range of `CD` (default: 0.1 to 1.5).")
    alpha: Angles | None = Field(default=None, description="Range of `alpha` (default: 18 to 354.3 deg).")
    n: Fractions | None = Field(default=None, description="Range of `n` (default: 0.2 to 0.8).")


class DwellOptimumTable(Table):
    """The search for the parameters that are not given: differential evolution, then Nelder's and Mead's method."""

    weights: DwellWeightsTable = Field(
        default_factory=DwellWeightsTable, description="Weights of the criteria f1 to f5."
    )
    ranges: RangesTable = Field(
        default_factory=RangesTable, description="Ranges of the parameters that are sought, in place of the usual ones."
    )
    population: Population = Field(default=96, description="Linkages of a generation of differential evolution.")
    generations: Generations = Field(default=60, description="Generations at most.")
    polish: Evaluations = Field(
        default=150, description="Evaluations of Nelder's and Mead's method at the end; 0: none."
    )


class DwellTable(Table):
    """A six-bar of class IV with a dwell."""

    dwell: Dwelling = Field(description="phi_B: turn of the crank while the output stands, from position 1 to 3.")
    output: Kind = Field(default="slider", description='The output: a `"slider"` or a `"rocker"`.')
    n: Fraction | None = Field(
        default=None,
        description="Part of the dwell after which the output moves along the crank: "
        "it divides the turn into the strokes (default: 0.5).",
    )
    working_angle: Stroke | None = Field(
        default=None,
        description="Turn of the crank on the stroke towards the dwell, in place of `n`: "
        "n = (180 deg - angle)/phi_B, clockwise 1 - n, then corrected.",
    )
    k: Reverse = Field(default=0, description="1 turns the sense in which S of a slider grows about.")
    crank_sense: Sense = Field(
        default="ccw", description='`"ccw"`, counter-clockwise, or `"cw"`: clockwise the crank meets position 3 first.'
    )
    swing: Swing | None = Field(
        default=None, description="Swing of a rocker; l_OF = l_OA/sin(swing/2), then corrected."
    )
    pivot_side: Side | None = Field(
        default=None,
        description='`"left"` or `"right"`: side of the crank, at the part `n` of the dwell, on which F is (default: '
        "the better).",
    )
    pivot: Annotated[list[Place], _PAIR] | None = Field(
        default=None,
        description="F of a rocker, `[x, y]` in parts of l_OB, in place of `swing` and `n`; "
        "at dwell O is `[0, 0]` and B `[1, 0]`.",
    )
    exact: bool = Field(
        default=True,
        description="Whether n and l_OF are corrected until working angle and swing are met exactly; `false`: "
        "the rules alone.",
    )
    working: Working = Field(
        default="towards", description='`"towards"` or `"away"`: which stroke, seen from the dwell, is the working one.'
    )
    frame: Size | None = Field(
        default=None, description="l_OB: distance of O from B at dwell, the scale (default: 1 m)."
    )
    stroke: Size | None = Field(default=None, description="h: stroke of a slider, in place of l_OB.")
    resistance: Resistance | None = Field(
        default=None,
        description="Resistance on the output, a force on a slider, a moment on a rocker (default: 1). "
        "Forces of the table are those against a resistance to a growing S.",
    )
    arc_steps: Steps = Field(
        default=12,
        description="Steps of the arc of the relative trajectory, a cross-check of the motion by a periodic cubic "
        "spline.",
    )
    positions: PositionsTable = Field(
        default_factory=PositionsTable, description="Parameters of the three positions that are given."
    )
    lengths: DwellLengthsTable | None = Field(
        default=None, description="Lengths of the linkage, in place of the positions."
    )
    optimum: DwellOptimumTable | None = Field(
        default=None, description="The search for the parameters that are not given."
    )
