"""``[torque]``: a torque diagram alone, in place of a mechanism."""

import math
from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.identifiers import Name
from tmmcalc.spec.quantities import Angle, AngularSpeed, Inertia, Moment, Number, Quantity
from tmmcalc.spec.table import Table

DiagramName = Annotated[str, Name("torque diagram")]
ConstantName = Annotated[str, Name("constant")]
Constant = Annotated[float, Number("a constant", "500")]
Order = Annotated[float, Number("an order", "2", above=0)]
Period = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]
Place = Annotated[float, Quantity("angle", at_least_zero=True)]
# An angle, then a moment: lists of one kind of value are what editors follow; the checks tell the two apart.
Piece = Annotated[list[Annotated[float, Quantity("angle", "moment")]], Field(min_length=2, max_length=2)]


def with_powers(formula: str) -> str:
    """Return a formula with its powers as ``**``, which is how formulas are read; in a spec ``^`` is one, as in units.

    >>> with_powers("sin(theta)^2")
    'sin(theta)**2'
    """
    return formula.replace("^", "**")


class HarmonicTable(Table):
    """One harmonic: cos cos(k theta) + sin sin(k theta)."""

    order: Order = Field(description="Order k: how often it repeats in a turn.")
    cos: Moment = Field(default=0.0, description="Amplitude of the cosine.")
    sin: Moment = Field(default=0.0, description="Amplitude of the sine.")


class HarmonicsTable(Table):
    """A constant moment and harmonics."""

    constant: Moment = Field(default=0.0, description="Constant part.")
    terms: list[HarmonicTable] = Field(min_length=1, description="The harmonics.")


class TorqueCurveTable(Table):
    """Moments at given angles, in the table itself or in a file."""

    theta: list[Place] | None = Field(
        default=None, min_length=2, description="Angles, ascending (default: equal steps over the period)."
    )
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Moment at each angle.")
    file: str | None = Field(
        default=None,
        description="CSV file of two columns with a header name[unit], in place of theta and moment; "
        "its path counts from the spec.",
    )
    interpolation: Literal["linear", "pchip"] = Field(
        default="linear", description="Straight lines, or a smooth monotone curve."
    )


class TorqueTable(Table):
    """The moment on the input shaft over one cycle, by exactly one law; a positive moment drives."""

    name: DiagramName = Field(default="torque", description="Name in tables.")
    speed: AngularSpeed = Field(description="Mean speed of the shaft.")
    period: Period = Field(default=2 * math.pi, description="Angle of the cycle.")
    formula: str | None = Field(default=None, description='Formula of theta [rad], such as "500*sin(theta)^2 - 120".')
    constants: dict[ConstantName, Constant] = Field(default={}, description="Numbers that the formula names.")
    harmonics: HarmonicsTable | None = Field(default=None, description="A constant moment and harmonics.")
    pieces: list[Piece] | None = Field(
        default=None,
        min_length=2,
        description="Straight pieces through points [theta, moment]; two points at one angle are a jump.",
    )
    table: TorqueCurveTable | None = Field(default=None, description="Values at given angles.")
    delays: list[Angle] | None = Field(
        default=None, min_length=1, description="Equal diagrams on one shaft: the delay of each."
    )
    count: int | None = Field(
        default=None, ge=1, le=1000, description="Equal diagrams with even delays over the period, in place of delays."
    )
    inertia: Inertia = Field(default=0.0, description="Constant moment of inertia of the shaft and what turns with it.")
    balanced: bool = Field(
        default=False, description="Whether a constant moment is added that makes the work of a cycle zero."
    )
