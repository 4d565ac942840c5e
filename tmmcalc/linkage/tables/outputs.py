"""``[[mechanism.outputs]]``: the coordinates whose displacement, velocity and acceleration are asked for."""

from typing import Literal

from pydantic import Field

from tmmcalc.linkage.tables.joints import JointName
from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.quantities import Angle
from tmmcalc.spec.table import Table


class OutputTable(Table):
    """One output coordinate: of a point along a direction, of a link (its angle) or of a prismatic joint."""

    name: JointName | None = Field(
        default=None, description="Name in columns and messages (default: the point, the link number or the joint)."
    )
    point: PointName | None = Field(default=None, description="Point whose coordinate along `direction` is the output.")
    direction: Angle = Field(default=0.0, description="Direction along which the point is followed, from the x axis.")
    link: int | None = Field(default=None, ge=1, description="Or the link whose angle is the output, by its number.")
    joint: JointName | None = Field(default=None, description="Or the prismatic joint whose coordinate is the output.")
    resistance: Literal["positive", "negative"] | None = Field(
        default=None,
        description='`"positive"` or `"negative"`: sense of the useful resistance along the output coordinate.',
    )
