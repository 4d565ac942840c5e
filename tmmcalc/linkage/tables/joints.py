"""``[[mechanism.joints]]``: the lower pairs between two links, revolute or prismatic."""

from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag

from tmmcalc.spec.identifiers import Name, NamePair, PointName
from tmmcalc.spec.quantities import Angle, Distance, Friction, LinkPair, Point, Size
from tmmcalc.spec.table import Table, tag

JointName = Annotated[str, Name("joint")]

NAME_TAG, POINT_TAG = tag("name"), tag("point")


def _form(value: object) -> str:
    return NAME_TAG if isinstance(value, str) else POINT_TAG


Place = Annotated[Annotated[PointName, Tag(NAME_TAG)] | Annotated[Point, Tag(POINT_TAG)], Discriminator(_form)]


class GuideTable(Table):
    """The line of a prismatic joint in the axes of its guide link."""

    through: Place = Field(description="A point of the line: the name of a point of the link, or `[x, y]`.")
    angle: Angle = Field(default=0.0, description="Angle of the line with the x axis of the link.")


class SliderTable(Table):
    """The line of a prismatic joint in the axes of its slider link."""

    through: Place = Field(
        default=[0.0, 0.0], description="A point of the line: the name of a point of the link, or `[x, y]`."
    )
    angle: Angle = Field(default=0.0, description="Angle of the line with the x axis of the link.")


class RevoluteTable(Table):
    """A pin: one point of each link, and the two coincide."""

    name: JointName = Field(description="Unique name of the joint.")
    kind: Literal["revolute"] = Field(description='`"revolute"`: a pin.')
    links: LinkPair = Field(description="The two links that the joint connects; 0 is the frame.")
    point: PointName | None = Field(
        default=None, description="Name of the pin on both links (default: the name of the joint)."
    )
    points: NamePair | None = Field(
        default=None,
        description="The two names of the pin, in the order of `links`, where they differ.",
    )
    friction: Friction = Field(default=0.0, description="Coefficient of friction; a pin needs its `radius` too.")
    radius: Distance = Field(default=0.0, description="Radius of the pin.")


class PrismaticTable(Table):
    """Two lines that coincide: one of the guide link, one of the slider."""

    name: JointName = Field(description="Unique name of the joint.")
    kind: Literal["prismatic"] = Field(description='`"prismatic"`: a slider on a guide.')
    links: LinkPair = Field(description="The slider, then the link that carries the guide; 0 is the frame.")
    guide: GuideTable = Field(
        description="The line in the axes of the guide link, the second of `links`: "
        '`{ through = "B", angle = "0 deg" }`.'
    )
    slider: SliderTable = Field(
        default_factory=SliderTable,
        description="The same line in the axes of the slider, the first of `links` (default: "
        "through its origin along its x axis).",
    )
    friction: Friction = Field(default=0.0, description="Coefficient of friction.")
    length: Size | None = Field(
        default=None,
        description="Length of the slider along the guide; with it, a slider that tilts bears on its two ends.",
    )


JointTable = Annotated[RevoluteTable | PrismaticTable, Field(discriminator="kind")]
