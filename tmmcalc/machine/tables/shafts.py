"""``[[shafts]]``: the elastic drive from the motor to the crank, one entry a shaft, the motor's side first."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.identifiers import Words
from tmmcalc.spec.quantities import Inertia, Quantity, Ratio
from tmmcalc.spec.table import Table

ShaftName = Annotated[str, Words("shaft")]
Stiffness = Annotated[float, Quantity("torsional stiffness", at_least_zero=True)]
Damping = Annotated[float, Quantity("torsional damping", at_least_zero=True)]


class ShaftTable(Table):
    """An elastic damped shaft, the gear behind it, and the mass behind both; each on its own shaft."""

    name: ShaftName | None = Field(default=None, description="Unique name (default: `shaft 1` ...).")
    stiffness: Stiffness | None = Field(
        default=None, description="Stiffness, N*m/rad (default: rigid); 0 with a damping is a fluid coupling."
    )
    damping: Damping = Field(default=0.0, description="Damping coefficient, N*m*s/rad.")
    ratio: Ratio = Field(default=1.0, description="Speed of the mass before the shaft over that of the mass behind it.")
    behind_gear: bool = Field(
        default=False,
        description="Whether the elastic part turns with the mass behind the gear, and not with the one before it.",
    )
    inertia: Inertia | None = Field(
        default=None,
        description="Moment of inertia of the mass behind the shaft; the last one is the crank (0 unless it is "
        "given), which has gears, flywheel, further inertia and linkage besides.",
    )
