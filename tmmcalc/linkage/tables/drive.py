"""``[drive]``: how the drive acts on the crank."""

import math
from typing import Literal

from pydantic import Field

from tmmcalc.spec.quantities import Angle, Size
from tmmcalc.spec.table import Table


class DriveTable(Table):
    """A moment through a coupling, or the force of a pinion on a gear that the crank carries."""

    kind: Literal["coupling", "gear"] = Field(
        default="coupling",
        description='Kind of the drive, `"coupling"`: a moment; or `"gear"`: a force in the mesh of a gear that the '
        "crank carries.",
    )
    radius: Size | None = Field(default=None, description="Operating pitch radius of the gear on the crank.")
    mesh_angle: Angle = Field(default=math.pi / 9, description="Operating pressure angle of the mesh.")
    pinion: Angle | None = Field(
        default=None, description="Direction from the crank's pivot to the centre of the pinion, from the x axis."
    )
    internal: bool = Field(default=False, description="Whether the gear on the crank has internal teeth.")
