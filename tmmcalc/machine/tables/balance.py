"""``[balance]``: balancing of the linkage."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.linkage.tables.joints import Place
from tmmcalc.spec.quantities import Angle, Point, Quantity, Size
from tmmcalc.spec.table import Table

Weight = Annotated[float, Quantity("mass", at_least_zero=True, nonzero=True)]


class CounterweightTable(Table):
    """A counterweight on a link, its mass or its radius chosen; the rest follows."""

    link: int = Field(ge=1, description="Link that carries it.")
    mass: Weight | None = Field(default=None, description="Its mass.")
    radius: Size | None = Field(
        default=None,
        description="Or the distance of its centre from the link's pin on the frame or else its outer pin.",
    )


class RotatingWeightTable(Table):
    """A weight of the user's own on a shaft geared to the crank."""

    order: int = Field(
        ge=-1000,
        le=1000,
        description="Speed of its shaft over that of the crank: 1 on the crank itself, -1 against it at its speed, 2 "
        "and -2 twice as fast.",
    )
    mass: Weight = Field(description="Its mass.")
    radius: Size = Field(description="Distance of its centre from the axis.")
    angle: Angle = Field(
        default=0.0,
        description="Direction of the weight where the crank points along x (of order 1: against the crank).",
    )
    axis: Point | None = Field(default=None, description="Place of its shaft, `[x, y]` (default: the crank's pivot).")


class BalanceTable(Table):
    """Which schemes are tried against the shaking force, and what weights they are made of."""

    mass: Weight | None = Field(
        default=None, description="Mass of each rotating weight; or `radius`, the other follows."
    )
    radius: Size | None = Field(
        default=None,
        description="Distance of the centre of each rotating weight from the axis, in place of `mass` (default: "
        "the length of the crank).",
    )
    point: Place | None = Field(
        default=None,
        description="Moments are about it: a point of the frame by its name, or `[x, y]` (default: the crank's pivot).",
    )
    schemes: list[Literal["least squares", "minimax", "lanchester", "lanchester 2"]] = Field(
        default=["least squares", "minimax", "lanchester", "lanchester 2"],
        description='`"least squares"`, `"minimax"`: one counterweight on the crank, for the least mean square or '
        'the least maximum of the force; `"lanchester"`, `"lanchester 2"`: '
        "counter-rotating pairs of the first order, or of the first and second (default: all).",
    )
    counterweights: list[CounterweightTable] = Field(
        default=[],
        description='Static balancing by counterweights on links: `[{ link = 1, radius = "60 mm" }, { link = 3, mass '
        "= 4.5 }]`, each with a mass or a radius.",
    )
    add: list[RotatingWeightTable] = Field(
        default=[],
        description='Rotating weights of one\'s own: `[{ order = -1, mass = "2 kg", radius = "60 mm", angle = '
        '"180 deg", axis = [0, "-200 mm"] }]`.',
    )
