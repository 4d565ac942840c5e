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
        description="Approximate places of some moving points in the fixed axes, read off a drawing: "
        '`{ C = ["330 mm", "965 mm"] }`.',
    )
    variants: dict[LinkIds, Variant] = Field(
        default={},
        description='Sign by dyad, `{ "2-3" = -1 }`, the order of the links defines it; '
        'of a group of class III or higher the number of its assembly, `{ "2-3-4-5" = 3 }`, as `tmmcalc '
        "structure --assemblies` lists them.",
    )
    at: InputCoordinate | None = Field(
        default=None,
        description="Input coordinate at which the sketch was read, and at which assemblies are numbered (default: "
        "position 0).",
    )
