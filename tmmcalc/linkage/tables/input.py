"""``[mechanism.input]``: the input link, named by its joint with the frame, and its motion."""

from pydantic import Field

from tmmcalc.linkage.tables.joints import JointName
from tmmcalc.spec.quantities import InputAcceleration, InputSpeed, InputStart
from tmmcalc.spec.table import Table


class InputTable(Table):
    """The input link and its motion."""

    joint: JointName = Field(
        description="Name of the joint between the frame and the input link, revolute for a crank, prismatic for a "
        "driven slider; or of a driven length between moving links."
    )
    speed: InputSpeed = Field(
        default=1.0,
        description="Mean speed, not zero; its sign is the sense of the motion, counter-clockwise positive. A "
        "mechanism without masses and loads may leave it out: its velocities are then those at 1 rad/s or 1 m/s. Or "
        '`"by the motor"`, or `"by the motor, clockwise"`: of a crank, the mean speed of the motion that the motor '
        "gives it through the ratio that is given, in `[transmission]`, `[[shafts]]` or `[train]`.",
    )
    acceleration: InputAcceleration = Field(
        default=0.0,
        description="Acceleration of the input, angular (crank) or linear (slider), constant over the grid.",
    )
    start: InputStart = Field(
        default="extreme",
        description="Input coordinate of position 0: an angle (of the input link's own x axis), a length for a "
        'driven slider, or `"extreme"`, the dead centre of the first output before its working stroke.',
    )
