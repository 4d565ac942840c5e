"""``[flywheel]``: the flywheel that is asked for, or the one that is there."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.quantities import Inertia, Number, Quantity, Ratio, Size
from tmmcalc.spec.table import Table

Unevenness = Annotated[float, Number("a coefficient of unevenness", "0.04", above=0, below=1)]
Density = Annotated[float, Quantity("density", at_least_zero=True, nonzero=True)]
RimSpeed = Annotated[float, Quantity("speed", at_least_zero=True, nonzero=True)]


class FlywheelTable(Table):
    """A flywheel: the unevenness that it has to keep, its shaft, and the size of its rim."""

    delta: Unevenness | None = Field(
        default=None, description='Allowed coefficient of unevenness of the speed, such as `"1/25"`.'
    )
    inertia: Inertia | None = Field(
        default=None, description="Moment of inertia of a flywheel that is there, on its own shaft."
    )
    shaft: Literal["input", "motor"] | None = Field(
        default=None,
        description='Shaft of the flywheel: of the crank, `"input"`, or of the motor, `"motor"` (default: `"input"`).',
    )
    ratio: Ratio | None = Field(
        default=None, description="Speed of another shaft, which carries the flywheel, over that of the crank."
    )
    diameter: Size | None = Field(
        default=None, description="Mean diameter of the rim; it follows from width and thickness."
    )
    width: Size | None = Field(default=None, description="Width of the rim, along the axis.")
    thickness: Size | None = Field(default=None, description="Thickness of the rim, along the radius.")
    material: Literal["cast iron", "cast steel", "steel"] = Field(
        default="cast iron", description='Material of the rim: `"cast iron"`, `"cast steel"` or `"steel"`.'
    )
    density: Density | None = Field(default=None, description="Density of the rim (default: of the material).")
    speed_limit: RimSpeed | None = Field(
        default=None, description="Highest allowed speed of the rim (default: of the material)."
    )
