"""``[[springs]]``: springs and dampers between two links."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.linkage.tables.joints import Place
from tmmcalc.spec.identifiers import Name
from tmmcalc.spec.quantities import Angle, Distance, LinkPair, Quantity
from tmmcalc.spec.table import Table

SpringName = Annotated[str, Name("spring")]
Stiffness = Annotated[float, Quantity("stiffness", "torsional stiffness", at_least_zero=True)]
Damping = Annotated[float, Quantity("damping", "torsional damping", at_least_zero=True)]


class SpringTable(Table):
    """A spring with its damper: along the line of two points, or about a pin."""

    name: SpringName | None = Field(default=None, description="Unique name (default: `spring 1` ...).")
    kind: Literal["linear", "torsion"] = Field(
        default="linear", description='Kind of the spring, `"linear"`, or `"torsion"`: a moment between two links.'
    )
    links: LinkPair = Field(description="The two links; 0 is the frame.")
    points: list[Place] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description='Linear: its ends on the two links, each the name of a point or `[x, y]`, `["B", [0.1, 0.2]]`.',
    )
    stiffness: Stiffness = Field(default=0.0, description="Stiffness, N/m, or N*m/rad.")
    free_length: Distance | None = Field(default=None, description="Linear: length without load.")
    free_angle: Angle | None = Field(
        default=None, description="Torsion: angle of the second link less that of the first, without load."
    )
    damping: Damping = Field(default=0.0, description="Damping coefficient, N*s/m, or N*m*s/rad.")
