"""``[engine]``: the balance of an engine with several cranks."""

import math
from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag

from tmmcalc.spec.quantities import Angle, AngularSpeed, Length, Mass, Size
from tmmcalc.spec.table import Table, tag

COUNT_TAG, LIST_TAG = tag("count"), tag("list")
CylinderNumber = Annotated[int, Field(ge=1)]


class CylinderTable(Table):
    """One cylinder; sizes and masses that it lacks are those of ``[engine]``."""

    axis_angle: Angle = Field(default=math.pi / 2, description="Direction from the shaft to the cylinder.")
    crank_angle: Angle = Field(description="Direction of its crank where the shaft's angle is 0.")
    position: Length = Field(description="Its place along the shaft.")
    crank_radius: Size | None = Field(default=None, description="Its own length of the crank (default: of `[engine]`).")
    rod_length: Size | None = Field(
        default=None, description="Its own length of the connecting rod (default: of `[engine]`)."
    )
    reciprocating_mass: Mass | None = Field(
        default=None, description="Its own mass of the piston and its part of the rod (default: of `[engine]`)."
    )
    rotating_mass: Mass | None = Field(
        default=None, description="Its own unbalanced mass at the crank pin (default: of `[engine]`)."
    )
    offset: Length | None = Field(
        default=None,
        description="Distance at which its own axis passes the shaft on the left (default: of `[engine]`).",
    )


def _form(value: object) -> str:
    return LIST_TAG if isinstance(value, list | dict) else COUNT_TAG


Cylinders = Annotated[
    Annotated[int, Field(ge=1, le=100), Tag(COUNT_TAG)]
    | Annotated[list[CylinderTable], Field(min_length=1), Tag(LIST_TAG)],
    Discriminator(_form),
]


class EngineTable(Table):
    """An engine by its arrangement and the number of its cylinders, or cylinder by cylinder."""

    speed: AngularSpeed = Field(description="Speed of the shaft.")
    arrangement: Literal["in-line", "vee"] | None = Field(
        default=None,
        description='`"in-line"`: upright, or `"vee"`: two banks symmetric to the vertical, two cylinders on every '
        "throw, the left one first.",
    )
    cylinders: Cylinders = Field(
        description="How many cylinders an arrangement has; or each for itself, `[[engine.cylinders]]`."
    )
    angle: Angle | None = Field(default=None, description="Vee: angle between the banks.")
    spacing: Size | None = Field(default=None, description="Distance of neighbouring throws along the shaft.")
    crank_radius: Size | None = Field(default=None, description="Length of the crank of every cylinder.")
    rod_length: Size | None = Field(default=None, description="Length of the connecting rod of every cylinder.")
    reciprocating_mass: Mass | None = Field(
        default=None, description="Mass of the piston and its part of the rod, of one cylinder."
    )
    rotating_mass: Mass = Field(default=0.0, description="Unbalanced mass at the crank pin, of one cylinder.")
    offset: Length = Field(default=0.0, description="Distance at which the cylinders' axes pass the shaft on the left.")
    strokes: Literal[2, 4] = Field(default=4, description="Strokes of the cycle: 4 or 2.")
    firing_order: list[CylinderNumber] | None = Field(
        default=None,
        min_length=1,
        description="Cylinders in the order in which they fire: `[1, 3, 4, 2]` (default: in line the customary one).",
    )
    throws: list[Angle] | None = Field(
        default=None,
        min_length=1,
        description="Angles of the cranks against the first (default: by the firing order; "
        "of a vee the customary ones).",
    )
    split: Angle = Field(default=0.0, description="Vee: angle by which the right cylinder's pin leads the left one's.")
    stagger: Length = Field(default=0.0, description="Vee: distance of the two cylinders of a throw along the shaft.")
    orders: list[CylinderNumber] = Field(
        default=[1, 2, 4, 6], min_length=1, description="Orders of the shaft speed that are told apart."
    )
