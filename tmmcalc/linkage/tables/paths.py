"""``[[paths]]``: the wanted path of a point of the linkage."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.identifiers import Name, PointName
from tmmcalc.spec.quantities import Angle, InputCoordinate, Point
from tmmcalc.spec.table import Table

PathName = Annotated[str, Name("path")]


class PathTable(Table):
    """Points of the plane that a point of the linkage is to pass, and when."""

    name: PathName | None = Field(default=None, description="Unique name (default: the point).")
    point: PointName = Field(description="Point of a moving link whose path is meant.")
    through: list[Point] = Field(
        min_length=1, max_length=1000, description="Points `[[x, y], ...]` of the plane that it is to pass, in order."
    )
    at: list[InputCoordinate] | None = Field(
        default=None,
        description="Prescribed timing: the input coordinate at each of these points, counted from position 0 as `phi` "
        "is in tables (default: the place of the path nearest to each point counts).",
    )
    turn: Angle = Field(default=0.0, description="Angle by which all points are turned about the origin.")
    shift: Point = Field(default=[0.0, 0.0], description="`[x, y]` by which all points are moved, after the turn.")
