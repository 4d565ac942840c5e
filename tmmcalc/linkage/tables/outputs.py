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
    point: PointName | None = Field(default=None, description="Point whose displacement along direction is the output.")
    direction: Angle = Field(default=0.0, description="Direction along which the point is followed, from the x axis.")
    link: int | None = Field(default=None, ge=1, description="Link whose angle is the output.")
    joint: JointName | None = Field(default=None, description="Prismatic joint whose coordinate is the output.")
    resistance: Literal["positive", "negative"] | None = Field(
        default=None, description="Sense of the useful resistance along the output coordinate."
    )
