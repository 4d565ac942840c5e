"""``[mechanism.assembly]``: which of the possible positions of the links is meant."""

from typing import Annotated

from pydantic import Field, WithJsonSchema

from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.quantities import InputCoordinate, Point
from tmmcalc.spec.table import Table

LinkIds = Annotated[str, WithJsonSchema({"type": "string", "pattern": "^[0-9]+(-[0-9]+)+$"})]
# The checks hold the variant of two links to 1 and -1, and the number of an assembly to 1 and more.
Variant = Annotated[int, WithJsonSchema({"type": "integer"})]


class AssemblyTable(Table):
    """The assembly variant: read off a sketch, or given by group."""

    sketch: dict[PointName, Point] = Field(
        default={},
        description="Approximate positions [x, y] of moving points in the fixed axes, as read off a sketch.",
    )
    variants: dict[LinkIds, Variant] = Field(
        default={},
        description='Variant by group: of a dyad its sign, "2-3" = 1 or -1, the order of the links defines it; '
        'of a higher group the number of its assembly, "2-3-4-5" = 2.',
    )
    at: InputCoordinate | None = Field(
        default=None,
        description="Input coordinate at which the sketch was read, and at which assemblies are numbered "
        "(default: position 0).",
    )
