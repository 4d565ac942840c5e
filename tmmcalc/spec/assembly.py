"""``[mechanism.assembly]``: which of the possible positions of the links is meant."""

from typing import Annotated

from pydantic import Field, WithJsonSchema

from .quantities import InputCoordinate, Point, PointName
from .table import Table

LinkIds = Annotated[str, WithJsonSchema({"type": "string", "pattern": "^[0-9]+-[0-9]+$"})]
# Not Literal[1, -1]: pydantic takes true for 1 there. The checks hold the value to 1 and -1.
Sign = Annotated[int, WithJsonSchema({"enum": [1, -1]})]


class AssemblyTable(Table):
    """The assembly variant: read off a sketch, or given by the sign of each group."""

    sketch: dict[PointName, Point] = Field(
        default={},
        description="Approximate positions [x, y] of moving points in the fixed axes, as read off a sketch.",
    )
    variants: dict[LinkIds, Sign] = Field(
        default={},
        description='Sign of the variant by group: "2-3" = 1 or -1; the order of the links defines the sign.',
    )
    at: InputCoordinate | None = Field(
        default=None, description="Input coordinate at which the sketch was read (default: position 0)."
    )
