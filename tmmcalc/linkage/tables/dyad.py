"""``[dyad]``: a dyad by itself: its kind and metric, the states of its outer joints, points of its links."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.choices import Known
from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Angle, Length, Point, Quantity, Size
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

METRIC = {  # the keys of every kind, of its lengths first: these have no default
    "RRR": ("length_a", "length_b", "variant"),
    "RRP": ("length_a", "offset_b", "variant"),
    "RPR": ("offset_a", "variant"),
    "PRP": ("offset_a", "offset_b"),
    "RPP": ("offset_a", "offset_b", "turn"),
}
MIRRORED = {"PRR": "RRP", "PPR": "RPP"}


class DyadKind(Known):
    """A kind of dyad by its letters; of a mirror form it says how it is written."""

    def read(self, value: object) -> str:
        """Return the kind; raise UnitError with the nearest one, or with the form that a mirror form has."""
        if isinstance(value, str) and value in MIRRORED:
            kind = MIRRORED[value]
            remedy = f'write kind = "{kind}" and exchange the links: the prismatic outer joint is that of b'
            raise UnitError(f"{show(value)} is the mirror form of {kind}", remedy)
        return super().read(value)


Kind = Annotated[str, DyadKind("kind of dyad", tuple(METRIC))]
Velocity = Annotated[list[Annotated[float, Quantity("speed")]], Field(min_length=2, max_length=2)]
Acceleration = Annotated[list[Annotated[float, Quantity("acceleration")]], Field(min_length=2, max_length=2)]
AngularSpeed = Annotated[float, Quantity("angular speed")]
AngularAcceleration = Annotated[float, Quantity("angular acceleration")]


class PortTable(Table):
    """The state of an outer joint: that of a point, and of a guide how it stands and turns."""

    point: Point = Field(description="The pin; of a guide a point of its line, from which the slider is measured.")
    velocity: Velocity = Field(default=[0.0, 0.0], description="Velocity of this point, along x and y.")
    acceleration: Acceleration = Field(default=[0.0, 0.0], description="Acceleration of this point, along x and y.")
    angle: Angle | None = Field(default=None, description="Angle of a guide with the x axis (default: 0).")
    omega: AngularSpeed | None = Field(default=None, description="Angular velocity of a guide (default: 0).")
    eps: AngularAcceleration | None = Field(default=None, description="Angular acceleration of a guide (default: 0).")


class DyadTable(Table):
    """A dyad: two links a and b with their inner joint, moved by their outer joints."""

    kind: Kind = Field(
        description='The joints, outer of a, inner, outer of b, R revolute and P prismatic: `"RRR"`, `"RRP"`, `"RPR"`, '
        '`"PRP"`, `"RPP"`.'
    )
    length_a: Size | None = Field(
        default=None, description="Length of a from its outer pin to the inner one (RRR, RRP, which need it)."
    )
    length_b: Size | None = Field(default=None, description="The same of b (RRR, which needs it).")
    offset_a: Length | None = Field(
        default=None,
        description="Distance to the left of the line on which a slides (default: 0): of its pin (RPR, RPP), of the "
        "inner pin (PRP).",
    )
    offset_b: Length | None = Field(
        default=None,
        description="Distance to the left of the guide of b (default: 0): of the inner pin (RRP, PRP), of the point "
        "from which a slides (RPP).",
    )
    turn: Angle | None = Field(
        default=None, description="Angle from the guide of b to the line on which a slides, of RPP (default: 90 deg)."
    )
    variant: Literal[1, -1] | None = Field(
        default=None,
        description="Assembly, 1 or -1 (default: 1). 1: the inner pin to the left of the line from the outer pin of a "
        "to that of b (RRR), ahead of the pin of a along the guide (RRP), the pin of a ahead of that of b along the "
        "line (RPR).",
    )
    first: PortTable = Field(description="The outer joint of a: a pin, or of PRP a guide.")
    second: PortTable = Field(description="The outer joint of b: a pin (RRR, RPR), or a guide.")
    points_a: dict[PointName, Point] = Field(
        default={},
        description="Points of a whose motion is told, in its axes: origin in its outer pin (PRP: the inner one), x "
        'axis towards the inner pin or along its line: `{ E = ["300 mm", "50 mm"] }`.',
    )
    points_b: dict[PointName, Point] = Field(
        default={},
        description="Points of b, in the same way (RRP: origin in the inner pin; RPP: in the point of its guide at the "
        "coordinate `second`).",
    )
