"""``[mechanism.input]``: the input link, named by its joint with the frame, and its motion."""

from pydantic import Field

from tmmcalc.linkage.tables.joints import JointName
from tmmcalc.spec.quantities import InputAcceleration, InputSpeed, InputStart
from tmmcalc.spec.table import Table


class InputTable(Table):
    """The input link and its motion."""

    joint: JointName = Field(
        description="Name of the joint of the input link with the frame, or of a driven length between moving links."
    )
    speed: InputSpeed = Field(
        description="Mean speed of the input, not zero; counter-clockwise is positive.",
    )
    acceleration: InputAcceleration = Field(
        default=0.0, description="Acceleration of the input, constant over the grid."
    )
    start: InputStart = Field(
        default="extreme",
        description='Coordinate of position 0, or "extreme": the dead centre before the working stroke.',
    )
