"""``[transmission]``: the gears between the motor and the crank, or the pinion of an open pair on it."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.quantities import Inertia, Number, Ratio
from tmmcalc.spec.table import Table

Efficiency = Annotated[float, Number("an efficiency", "0.95", above=0, at_most=1)]


class TransmissionTable(Table):
    """The gears between the motor and the crank."""

    ratio: Ratio | None = Field(
        default=None,
        description="Speed of the motor over that of the crank, or of the pinion of `[open_pair]` (default: that of "
        "`[[shafts]]`, of the best train of `[criteria]`, or rated speed over the input's mean speed, each without "
        "that of `[open_pair]`).",
    )
    efficiency: Efficiency | None = Field(
        default=None, description="Efficiency of the gears (default: that of the best train, or 1)."
    )
    inertia: Inertia | None = Field(
        default=None,
        description="Moment of inertia of the gears, reduced to the crank, or to the pinion of `[open_pair]` (default: "
        "that of the best train, or 0).",
    )
