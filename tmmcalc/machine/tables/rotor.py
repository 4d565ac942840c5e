"""``[rotor]``: static and two-plane balancing of a rigid rotor."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.quantities import Angle, AngularSpeed, Grade, Length, Quantity, Size
from tmmcalc.spec.table import Table

Heavy = Annotated[float, Quantity("mass", at_least_zero=True, nonzero=True)]
Signed = Annotated[float, Quantity("mass")]
StaticMoment = Annotated[float, Quantity("static moment", at_least_zero=True)]
Planes = Annotated[list[Length], Field(min_length=2, max_length=2)]


class UnbalanceTable(Table):
    """A mass off the axis, or its static moment."""

    mass: Signed | None = Field(default=None, description="A mass off the axis; that of a drilled hole is negative.")
    radius: Size | None = Field(default=None, description="Distance of its centre from the axis.")
    moment: StaticMoment | None = Field(
        default=None, description='Or its static moment, `"12 g*mm"`, in place of mass and radius.'
    )
    angle: Angle = Field(default=0.0, description="Its direction in axes of the rotor.")
    position: Length = Field(description="Its place along the axis.")


class RotorTable(Table):
    """A rigid rotor on two bearings and its unbalances."""

    mass: Heavy = Field(description="Mass of the rotor.")
    center: Length = Field(description="Place of the centre of mass along the axis.")
    bearings: Planes = Field(description='Places of the two bearings along the axis, `[0, "400 mm"]`.')
    speed: AngularSpeed = Field(description="Highest service speed.")
    planes: Planes = Field(description="Places of the two correction planes along the axis.")
    static_plane: Length | None = Field(
        default=None, description="Place of the one correction plane of static balancing (default: the centre of mass)."
    )
    radius: Size | None = Field(
        default=None, description="Radius of the correction masses; without it static moments are given alone."
    )
    grade: Grade | None = Field(default=None, description='Balance quality grade to be kept: `"G6.3"` or `6.3`.')
    unbalances: list[UnbalanceTable] = Field(min_length=1, description="Masses off the axis.")
