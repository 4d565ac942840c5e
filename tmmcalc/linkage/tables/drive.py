"""``[drive]``: how the drive acts on the crank."""

from typing import Literal

from pydantic import Field, PrivateAttr

from tmmcalc.spec.quantities import Angle, Size
from tmmcalc.spec.table import Table


class DriveTable(Table):
    """A moment through a coupling, or the force of a pinion on a gear that the crank carries."""

    kind: Literal["coupling", "gear"] = Field(
        default="coupling",
        description='Kind of the drive, `"coupling"`: a moment; or `"gear"`: a force in the mesh of a gear that the '
        "crank carries.",
    )
    radius: Size | None = Field(
        default=None, description="Operating pitch radius of the gear on the crank (default: that of `[open_pair]`)."
    )
    mesh_angle: Angle | None = Field(
        default=None, description="Operating pressure angle of the mesh (default: that of `[open_pair]`, or 20 deg)."
    )
    pinion: Angle | None = Field(
        default=None, description="Direction from the crank's pivot to the centre of the pinion, from the x axis."
    )
    internal: bool | None = Field(
        default=None,
        description="Whether the gear on the crank has internal teeth (default: as `[open_pair]` has it, or `false`).",
    )
    _open: str = PrivateAttr(default="")  # the open pair that radius and angle are of; empty: given
