"""``[motion]``: how the motion of the machine is found."""

from typing import Literal

from pydantic import Field

from tmmcalc.spec.quantities import AngularSpeed, Inertia
from tmmcalc.spec.table import Table


class MotionTable(Table):
    """What drives the machine, and its constant moment of inertia beside the parts that the spec names."""

    drive: Literal["motor", "positional", "none"] | None = Field(
        default=None,
        description='`"motor"`; or `"positional"`: a constant moment that holds the mean speed; or `"none"`: '
        'nothing but the loads (default: `"motor"` if there is `[motor]`, else `"positional"`).',
    )
    inertia: Inertia = Field(
        default=0.0,
        description="Further constant moment of inertia on the crank, beside rotor, gears and flywheel.",
    )
    speed: AngularSpeed | None = Field(
        default=None,
        description="Mean speed of the crank without a motor (default: that of the input, or of the torque diagram).",
    )
