"""``[[mechanism.links]]``: the moving links, each with its points in its own axes."""

from pydantic import Field

from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.quantities import Inertia, Mass, Point
from tmmcalc.spec.table import Table


class LinkTable(Table):
    """A rigid moving link."""

    id: int = Field(ge=1, description="Number of the link, 1 and up; 0 is the frame.")
    name: str = Field(default="", description="What the link is called in tables and messages.")
    points: dict[PointName, Point] = Field(
        default={},
        description="Named points in the link's own axes, the metric of the mechanism: "
        '`{ B = [0, 0], C = ["1020 mm", 0] }`.',
    )
    mass: Mass | None = Field(default=None, description="Mass of the link; without it the link is massless.")
    inertia: Inertia | None = Field(
        default=None, description="Moment of inertia about the centre of mass; without it none, as of a point mass."
    )
    center: Point | None = Field(
        default=None,
        description="Centre of mass in the link's own axes; it becomes the point `S<id>`. "
        "Without it the mass is in the origin of the axes.",
    )
