"""``[[loads]]``: technological forces and moments on the links, each with its law and where it acts."""

from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field

from tmmcalc.linkage.loading import Role
from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.tables.joints import Place
from tmmcalc.spec.identifiers import Name, PositionLabel
from tmmcalc.spec.quantities import Angle, InputDistance, Number, Quantity
from tmmcalc.spec.table import Table

LoadName = Annotated[str, Name("load")]
Period = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]
Factor = Annotated[float, Number("a load factor", "1.2", at_least=0)]


class ActingTable(Table):
    """What a load acts on."""

    name: LoadName | None = Field(
        default=None, description="Unique name (default: `Q<link>`); a second load on link 5 is `Q5'`."
    )
    link: int = Field(ge=1, description="Link that the load acts on.")
    point: Place | None = Field(
        default=None,
        description="Where a force acts: the name of a point of the link, or `[x, y]` in its axes; a moment has none.",
    )
    direction: Angle = Field(default=0.0, description="Direction of a positive force, from the x axis.")
    axes: int = Field(
        default=0,
        ge=0,
        description="Link in whose axes the direction is given, so that it turns with it; 0: the fixed axes.",
    )
    against: int = Field(default=0, ge=0, description="Link that takes the opposite load, in the same line.")
    role: Role = Field(
        default="resistance",
        description='Whether the load is a useful `"resistance"`, a `"drive"`, or `"neutral"`, as a dead weight '
        "that is lifted and let down: its work is told either way, and a neutral load may do either.",
    )
    factor: Factor = Field(default=1.0, description="Load factor.")


def _lawful() -> dict[str, object]:
    """The body of a table with the keys of all laws."""
    body: dict[str, object] = {"__module__": __name__}
    annotations: dict[str, object] = {}
    for key, law in laws().items():
        annotation, description = law.spec_keys()[key]
        annotations[key] = annotation | None
        body[key] = Field(default=None, description=description)
    return {"__annotations__": annotations, **body}


if TYPE_CHECKING:
    LawTable = ActingTable
else:
    LawTable = type(Table)("LawTable", (ActingTable,), _lawful())


class LoadTable(LawTable):
    """A force at a point of a link, or a moment on it, by exactly one law."""

    stroke: Literal["working", "idle"] | None = Field(
        default=None, description='`"working"` or `"idle"`: the load acts on that stroke of an output.'
    )
    output: str | None = Field(default=None, description="Output whose stroke it is (default: the first).")
    between: list[InputDistance] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description='From the first angle to the second, counted from position 0 along the motion, `["30 deg", "180 '
        'deg"]`; `["300 deg", "60 deg"]` goes over position 0. Lengths for a driven slider.',
    )
    positions: list[PositionLabel] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description="From one position of the grid to another, by numbers or labels, `[2, 12]`; "
        '`"6\'"` is an added one.',
    )
    period: Period | None = Field(
        default=None,
        description="Angle after which a window of angles or positions comes back, or a polynomial, whole turns "
        '(default: 360 deg, or that of the table); `"720 deg"`: once in two turns, as in a four-stroke engine.',
    )
