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
        description="Or the distance of its centre from the link's pin on the frame, or else from its outer pin.",
    )


class RotatingWeightTable(Table):
    """A weight of the user's own on a shaft geared to the crank."""

    order: int = Field(
        ge=-1000, le=1000, description="Speed of its shaft over that of the crank; 1: on the crank, -1: against it."
    )
    mass: Weight = Field(description="Its mass.")
    radius: Size = Field(description="Distance of its centre from the axis.")
    angle: Angle = Field(
        default=0.0,
        description="Direction of its centre where the crank points along x; of order 1 against the crank.",
    )
    axis: Point | None = Field(default=None, description="Place of its shaft [x, y] (default: the crank's pivot).")


class BalanceTable(Table):
    """Which schemes are tried against the shaking force, and what weights they are made of."""

    mass: Weight | None = Field(default=None, description="Mass of each rotating weight.")
    radius: Size | None = Field(
        default=None, description="Or the distance of its centre from the axis (default: the length of the crank)."
    )
    point: Place | None = Field(
        default=None,
        description="Point about which moments are taken: of the frame, or [x, y] (default: the crank's pivot).",
    )
    schemes: list[Literal["least squares", "minimax", "lanchester", "lanchester 2"]] = Field(
        default=["least squares", "minimax", "lanchester", "lanchester 2"],
        description="A counterweight on the crank of least mean square or least maximum; counter-rotating pairs of "
        "the first order, or of the first and second.",
    )
    counterweights: list[CounterweightTable] = Field(default=[], description="Counterweights on links.")
    add: list[RotatingWeightTable] = Field(default=[], description="Rotating weights of the user's own.")
